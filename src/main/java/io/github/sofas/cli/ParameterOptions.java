package io.github.sofas.cli;

import io.github.sofas.flow.Parameter;
import io.github.sofas.flow.ParameterHandle;
import io.github.sofas.flow.SofasParameters;
import java.math.BigDecimal;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Model.ArgGroupSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import picocli.CommandLine.TypeConversionException;

/**
 * The algorithm's parameters on the command line. The options are not listed here: each {@link ParameterHandle} becomes
 * one, in its group, with the texts of its {@link Parameter}. The preset is the base, the config file overrides it, and
 * options override the config file.
 */
final class ParameterOptions {
    private static final List<ParameterHandle> OPTIONS = ParameterHandle.all();

    /** Names of the presets, for shell completion and messages. */
    private static final class PresetNames extends ArrayList<String> {
        private static final long serialVersionUID = 1L;

        PresetNames() {
            super(Arrays.stream(SofasParameters.Preset.values()).map(ParameterOptions::text).toList());
        }
    }

    /** Converts the names of presets as the help shows them. */
    private static final class PresetConverter implements ITypeConverter<SofasParameters.Preset> {
        @Override
        public SofasParameters.Preset convert(String text) {
            for (SofasParameters.Preset each : SofasParameters.Preset.values()) {
                if (text(each).equalsIgnoreCase(text)) {
                    return each;
                }
            }
            throw new TypeConversionException("unknown preset " + text);
        }
    }

    @Spec(Spec.Target.MIXEE)
    private CommandSpec command;

    @Option(names = "--preset", paramLabel = "PRESET", defaultValue = "default",
        completionCandidates = PresetNames.class, converter = PresetConverter.class,
        description = "Initial values of the algorithm parameters: ${COMPLETION-CANDIDATES}; default: "
        + "${DEFAULT-VALUE}.")
    private SofasParameters.Preset preset;

    @Option(names = "--config", paramLabel = "FILE",
        description = "Properties file with algorithm parameters, such as lifetime-px=6; options override it.")
    private Path config;

    /** Adds one option per parameter to a command that has this class as a mixin. */
    static void addTo(CommandSpec command, boolean shown) {
        Map<String, ArgGroupSpec.Builder> groups = new LinkedHashMap<>();
        for (ParameterHandle handle : OPTIONS) {
            groups.computeIfAbsent(handle.group(), name -> ArgGroupSpec.builder().validate(false).exclusive(false)
                    .order(100 + groups.size()).heading(shown ? "%nAlgorithm parameters, " + name + ":%n" : null))
                .addArg(OptionSpec.builder("--" + optionName(handle)).paramLabel(handle.isSwitch() ? "true|false" : "N")
                    .type(String.class).description(description(handle)).hidden(!shown).build());
        }
        groups.values().forEach(group -> command.addArgGroup(group.build()));
        for (String name : RemovedParameters.names()) {
            command.addOption(OptionSpec.builder("--" + name).type(String.class).hidden(true).build());
        }
    }

    /** The option of a parameter without its dashes: lifetimePx is lifetime-px. */
    static String optionName(ParameterHandle handle) {
        return handle.name().replaceAll("(?<=[a-z0-9])(?=[A-Z])", "-").toLowerCase(Locale.ROOT);
    }

    private static String description(ParameterHandle handle) {
        Parameter parameter = handle.declaration();
        StringBuilder text = new StringBuilder(parameter.value());
        if (!handle.isSwitch()) {
            text.append("; ").append(plain(parameter.min())).append(" to ").append(plain(parameter.max()));
            text.append(parameter.unit().isEmpty() ? "" : " " + parameter.unit());
        }
        String separator = "; ";
        for (SofasParameters.Preset each : List.of(SofasParameters.Preset.DEFAULT, SofasParameters.Preset.PAPER)) {
            if (handle.isUsedBy(each)) {
                text.append(separator).append(text(each)).append(' ')
                    .append(text(handle.get(SofasParameters.of(each))));
                separator = ", ";
            }
        }
        // Picocli interprets percent signs and variables in descriptions.
        return text.append('.').toString().replace("%", "%%").replace("${", "$ {");
    }

    private static String plain(double number) {
        return new BigDecimal(Double.toString(number)).stripTrailingZeros().toPlainString();
    }

    private static String text(Object value) {
        if (value instanceof Double) {
            return plain((Double) value);
        }
        return value instanceof Enum ? ((Enum<?>) value).name().toLowerCase(Locale.ROOT) : value.toString();
    }

    /** The config file; null if there is none. */
    Path config() {
        return config;
    }

    /**
     * The settings of the config file as options, without those that an option of the command line overrides.
     *
     * @throws IllegalArgumentException if the file cannot be read; the message is for the user
     */
    List<String> configAsOptions() {
        List<String> options = new ArrayList<>();
        if (config != null) {
            ConfigFile file = ConfigFile.read(config);
            for (String key : file.keys()) {
                if (!isGiven("--" + key)) {
                    options.add("--" + key + "=" + file.value(key));
                }
            }
        }
        return options;
    }

    /** Name of the preset that was chosen. */
    String presetName() {
        return text(preset);
    }

    /**
     * The parameters that were asked for.
     *
     * @throws ParameterException if a value is wrong or the config file has a key that is no parameter
     */
    SofasParameters parameters() {
        Map<ParameterHandle, Given> given = new LinkedHashMap<>();
        try {
            if (config != null) {
                readConfig(given);
            }
            for (String name : RemovedParameters.names()) {
                if (isGiven("--" + name)) {
                    throw new IllegalArgumentException("--" + RemovedParameters.message(name));
                }
            }
            for (ParameterHandle handle : OPTIONS) {
                String name = "--" + optionName(handle);
                if (isGiven(name)) {
                    given.put(handle, new Given(name, command.findOption(name).getValue()));
                }
            }
            return made(given);
        } catch (IllegalArgumentException e) {
            throw new ParameterException(command.commandLine(), e.getMessage(), e);
        }
    }

    private boolean isGiven(String option) {
        return command.commandLine().getParseResult().hasMatchedOption(command.findOption(option));
    }

    private void readConfig(Map<ParameterHandle, Given> given) {
        ConfigFile file = ConfigFile.read(config);
        List<String> names = OPTIONS.stream().map(ParameterOptions::optionName).toList();
        for (String key : file.keys()) {
            if (RemovedParameters.names().contains(key)) {
                throw new IllegalArgumentException(file.place(key) + RemovedParameters.message(key));
            }
            int index = names.indexOf(key);
            if (index < 0) {
                throw new IllegalArgumentException(file.place(key) + "unknown parameter \"" + key + "\"; known are "
                    + String.join(", ", names));
            }
            given.put(OPTIONS.get(index), new Given(file.place(key) + key, file.value(key)));
        }
    }

    /** The text that was given for a parameter, and its place: an option, or a line of a file. */
    private record Given(String place, String text) {
    }

    private SofasParameters made(Map<ParameterHandle, Given> given) {
        SofasParameters base = SofasParameters.of(preset);
        Map<String, Object> values = new LinkedHashMap<>();
        given.forEach((handle, each) -> values.put(handle.name(), value(handle, each)));
        try {
            return base.with(values);
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException(inUsersWords(e.getMessage(), given), e);
        }
    }

    private static Object value(ParameterHandle handle, Given given) {
        if (handle.isSwitch()) {
            if (!given.text.equalsIgnoreCase("true") && !given.text.equalsIgnoreCase("false")) {
                throw new IllegalArgumentException(given.place + " must be true or false but was \"" + given.text
                    + "\"");
            }
            return Boolean.valueOf(given.text);
        }
        try {
            return handle.isWhole() ? (Number) Long.valueOf(given.text) : (Number) new BigDecimal(given.text);
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException(given.place + " must be " + (handle.isWhole() ? "a whole number"
                : "a number") + " but was \"" + given.text + "\"", e);
        }
    }

    /** All parameters but the preset by the names of their options, group by group. */
    static Map<String, Object> asMap(SofasParameters parameters) {
        Map<String, Object> values = new LinkedHashMap<>();
        for (ParameterHandle handle : OPTIONS) {
            values.put(optionName(handle), handle.get(parameters));
        }
        return values;
    }

    /**
     * Rewrites a message in the user's words. The message begins with a parameter and may name another one that it is
     * compared with; the user wrote an option or a line of a file.
     */
    private static String inUsersWords(String message, Map<ParameterHandle, Given> given) {
        String text = message;
        for (ParameterHandle handle : OPTIONS) {
            String name = optionName(handle);
            if (message.startsWith(handle.name() + " ")) {
                Given its = given.get(handle);
                text = (its == null ? name : its.place) + text.substring(handle.name().length());
            } else if (!name.equals(handle.name())) {
                text = text.replace(" " + handle.name() + " ", " " + name + " ");
            }
        }
        return text;
    }
}
