package io.github.sofas.cli;

import io.github.sofas.flow.Parameter;
import io.github.sofas.flow.SofasParameters;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.RecordComponent;
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
 * The algorithm's parameters on the command line. The options are not listed here: each component of
 * {@link SofasParameters} is one, with the texts of its {@link Parameter}. The preset is the base, the config file
 * changes it, and options change that.
 */
final class ParameterOptions {
    private static final RecordComponent[] COMPONENTS = SofasParameters.class.getRecordComponents();
    /** All but the preset, which has an option of its own. */
    private static final List<RecordComponent> OPTIONS = Arrays.stream(COMPONENTS)
        .filter(component -> component.isAnnotationPresent(Parameter.class)).toList();
    private static final List<String> DESCRIPTIONS = descriptions();

    /** What shell completion offers. */
    private static final class PresetNames extends ArrayList<String> {
        private static final long serialVersionUID = 1L;

        PresetNames() {
            super(Arrays.stream(SofasParameters.Preset.values()).map(ParameterOptions::text).toList());
        }
    }

    /** Names presets in its message as the help does. */
    private static final class PresetConverter implements ITypeConverter<SofasParameters.Preset> {
        @Override
        public SofasParameters.Preset convert(String text) {
            for (SofasParameters.Preset each : SofasParameters.Preset.values()) {
                if (text(each).equalsIgnoreCase(text)) {
                    return each;
                }
            }
            throw new TypeConversionException("must be one of " + new PresetNames() + " but was \"" + text + "\"");
        }
    }

    @Spec(Spec.Target.MIXEE)
    private CommandSpec command;

    @Option(names = "--preset", paramLabel = "PRESET", defaultValue = "default",
        completionCandidates = PresetNames.class, converter = PresetConverter.class,
        description = "Base of the algorithm's parameters: ${COMPLETION-CANDIDATES}; default: ${DEFAULT-VALUE}.")
    private SofasParameters.Preset preset;

    @Option(names = "--config", paramLabel = "FILE",
        description = "Properties file with algorithm parameters, such as lifetime-px=6; options go before it.")
    private Path config;

    /** Adds one option a parameter to a command that has this class as a mixin. */
    static void addTo(CommandSpec command) {
        ArgGroupSpec.Builder group = ArgGroupSpec.builder().validate(false).exclusive(false).order(100)
            .heading("%nAlgorithm parameters, each over its value in the preset and the config file:%n");
        for (int i = 0; i < OPTIONS.size(); i++) {
            RecordComponent component = OPTIONS.get(i);
            group.addArg(OptionSpec.builder("--" + optionName(component)).paramLabel(label(component))
                .type(String.class).description(DESCRIPTIONS.get(i)).build());
        }
        command.addArgGroup(group.build());
    }

    /** The option of a component without its dashes: lifetimePx is lifetime-px. */
    static String optionName(RecordComponent component) {
        return component.getName().replaceAll("(?<=[a-z0-9])(?=[A-Z])", "-").toLowerCase(Locale.ROOT);
    }

    private static String label(RecordComponent component) {
        Class<?> type = component.getType();
        if (type == boolean.class) {
            return "true|false";
        }
        return type.isEnum() ? choices(type) : "N";
    }

    private static String choices(Class<?> type) {
        return String.join("|", Arrays.stream(type.getEnumConstants()).map(ParameterOptions::text).toList());
    }

    private static List<String> descriptions() {
        SofasParameters defaults = SofasParameters.defaults();
        SofasParameters paper = SofasParameters.paper();
        return OPTIONS.stream().map(component -> description(component, defaults, paper)).toList();
    }

    private static String description(RecordComponent component, SofasParameters defaults, SofasParameters paper) {
        Parameter parameter = component.getAnnotation(Parameter.class);
        StringBuilder text = new StringBuilder(parameter.value());
        if (component.getType() != boolean.class && !component.getType().isEnum()) {
            text.append("; ").append(plain(parameter.min())).append(" to ").append(plain(parameter.max()));
            text.append(parameter.unit().isEmpty() ? "" : " " + parameter.unit());
        }
        text.append("; default ").append(text(value(component, defaults)));
        text.append(", paper ").append(text(value(component, paper))).append('.');
        // Picocli reads percent signs and variables in descriptions.
        return text.toString().replace("%", "%%").replace("${", "$ {");
    }

    private static String plain(double number) {
        return new BigDecimal(Double.toString(number)).stripTrailingZeros().toPlainString();
    }

    private static String text(Object value) {
        if (value instanceof Double || value instanceof Float) {
            return plain(Double.parseDouble(value.toString()));
        }
        return value instanceof Enum ? ((Enum<?>) value).name().toLowerCase(Locale.ROOT) : value.toString();
    }

    /** Name of the preset that was chosen. */
    String presetName() {
        return text(preset);
    }

    /**
     * The parameters that were asked for.
     *
     * @throws ParameterException where a value is wrong or the config file has a key that is no parameter
     */
    SofasParameters parameters() {
        SofasParameters base = preset == SofasParameters.Preset.PAPER ? SofasParameters.paper()
            : SofasParameters.defaults();
        Map<String, Object> values = asMap(base);
        Map<String, String> places = new LinkedHashMap<>();
        try {
            if (config != null) {
                readConfig(values, places);
            }
            for (RecordComponent component : OPTIONS) {
                String name = optionName(component);
                OptionSpec option = command.findOption("--" + name);
                if (command.commandLine().getParseResult().hasMatchedOption(option)) {
                    values.put(name, convert("--" + name, component, option.getValue()));
                    places.put(name, "--" + name);
                }
            }
            return make(base, values, places);
        } catch (IllegalArgumentException e) {
            throw new ParameterException(command.commandLine(), e.getMessage(), e);
        }
    }

    private void readConfig(Map<String, Object> values, Map<String, String> places) {
        ConfigFile file = ConfigFile.read(config);
        List<String> names = OPTIONS.stream().map(ParameterOptions::optionName).toList();
        for (String key : file.keys()) {
            int index = names.indexOf(key);
            if (index < 0) {
                throw new IllegalArgumentException(file.place(key) + "unknown parameter \"" + key + "\"; known are "
                    + String.join(", ", names));
            }
            values.put(key, convert(file.place(key) + key, OPTIONS.get(index), file.value(key)));
            places.put(key, file.place(key) + key);
        }
    }

    private static Object convert(String place, RecordComponent component, String text) {
        Class<?> type = component.getType();
        try {
            if (type == int.class) {
                return Integer.valueOf(text);
            } else if (type == long.class) {
                return Long.valueOf(text);
            } else if (type == double.class) {
                return new BigDecimal(text).doubleValue();
            } else if (type == float.class) {
                return new BigDecimal(text).floatValue();
            }
        } catch (NumberFormatException e) {
            String kind = type == int.class || type == long.class ? "a whole number" : "a number";
            throw new IllegalArgumentException(place + " must be " + kind + " but was \"" + text + "\"", e);
        }
        Object[] choices = type == boolean.class ? new Object[] {true, false} : type.getEnumConstants();
        for (Object choice : choices) {
            if (text(choice).equalsIgnoreCase(text)) {
                return choice;
            }
        }
        throw new IllegalArgumentException(place + " must be one of " + Arrays.stream(choices)
            .map(ParameterOptions::text).toList() + " but was \"" + text + "\"");
    }

    /** Every parameter but the preset under its option's name, in the order of the record. */
    static Map<String, Object> asMap(SofasParameters parameters) {
        Map<String, Object> values = new LinkedHashMap<>();
        for (RecordComponent component : OPTIONS) {
            values.put(optionName(component), value(component, parameters));
        }
        return values;
    }

    private static Object value(RecordComponent component, SofasParameters parameters) {
        try {
            return component.getAccessor().invoke(parameters);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException("accessors of a public record can be called", e);
        }
    }

    private static SofasParameters make(SofasParameters base, Map<String, Object> values,
                                        Map<String, String> places) {
        Object[] arguments = Arrays.stream(COMPONENTS)
            .map(component -> values.getOrDefault(optionName(component), value(component, base))).toArray();
        Class<?>[] types = Arrays.stream(COMPONENTS).map(RecordComponent::getType).toArray(Class<?>[]::new);
        try {
            return SofasParameters.class.getConstructor(types).newInstance(arguments);
        } catch (InvocationTargetException e) {
            if (e.getCause() instanceof IllegalArgumentException) {
                throw new IllegalArgumentException(inUsersWords(e.getCause().getMessage(), places), e);
            }
            throw new IllegalStateException(e.getCause());
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException("the constructor of a public record can be called", e);
        }
    }

    /**
     * The record's message begins with the component and may name another that it is held against; the user wrote an
     * option or a line of a file.
     */
    private static String inUsersWords(String message, Map<String, String> places) {
        String text = message;
        for (RecordComponent component : OPTIONS) {
            String name = optionName(component);
            if (message.startsWith(component.getName() + " ")) {
                text = places.getOrDefault(name, name) + text.substring(component.getName().length());
            } else if (!name.equals(component.getName())) {
                text = text.replace(" " + component.getName() + " ", " " + name + " ");
            }
        }
        return text;
    }
}
