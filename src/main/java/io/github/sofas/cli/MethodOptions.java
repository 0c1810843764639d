package io.github.sofas.cli;

import io.github.sofas.baseline.LocalPlanes;
import io.github.sofas.baseline.LucasKanade;
import io.github.sofas.baseline.LucasKanade.Derivative;
import io.github.sofas.flow.Sofas;
import io.github.sofas.flow.SofasParameters;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/**
 * Options that choose the method that labels the events. Used together with {@link ParameterOptions}, which has the
 * parameters of SOFAS.
 */
final class MethodOptions {
    @Spec(Spec.Target.MIXEE)
    private CommandSpec command;

    @Option(names = "--method", paramLabel = "METHOD", defaultValue = "sofas",
        description = "Method: ${COMPLETION-CANDIDATES}; default: ${DEFAULT-VALUE}. The last two find no segments: "
        + "each event with flow gets segment 1.")
    private Method method;

    @Option(names = "--derivative", paramLabel = "DERIVATIVE",
        description = "Derivative used by lucas-kanade: ${COMPLETION-CANDIDATES}; default: savitzky-golay.")
    private LucasKanadeDerivative derivative;

    /** The methods. */
    enum Method {
        /** Ours. */
        SOFAS,
        /** Lucas-Kanade for events. */
        LUCAS_KANADE,
        /** Local plane fitting. */
        LOCAL_PLANES;

        @Override
        public String toString() {
            return hyphenated(this);
        }
    }

    /** The derivatives of Lucas-Kanade, named as on the command line. */
    enum LucasKanadeDerivative {
        /** The best of them. */
        SAVITZKY_GOLAY(Derivative.SAVITZKY_GOLAY),
        /** jAER's default. */
        CENTRAL_DIFFERENCE(Derivative.CENTRAL_DIFFERENCE),
        /** The original. */
        BACKWARD_DIFFERENCE(Derivative.BACKWARD_DIFFERENCE);

        private final Derivative derivative;

        LucasKanadeDerivative(Derivative derivative) {
            this.derivative = derivative;
        }

        @Override
        public String toString() {
            return hyphenated(this);
        }
    }

    /**
     * Returns the method that was asked for.
     *
     * @throws ParameterException if an option belongs to another method, or a value is wrong
     */
    MethodChoice choice(ParameterOptions parameterOptions) {
        if (method != Method.LUCAS_KANADE && derivative != null) {
            throw new ParameterException(command.commandLine(), "--derivative needs --method lucas-kanade but was "
            + "used with "
                + method);
        }
        if (method == Method.SOFAS) {
            SofasParameters parameters = parameterOptions.parameters();
            return new MethodChoice(method.toString(), parameterOptions.presetName(),
                ParameterOptions.asMap(parameters),
                (sensor, ended) -> new Sofas(sensor, parameters, ended));
        }
        refuseParametersOfSofas();
        Map<String, Object> parameters = new LinkedHashMap<>();
        if (method == Method.LOCAL_PLANES) {
            parameters.put("window-radius", LocalPlanes.WINDOW_RADIUS);
            parameters.put("max-age-us", LocalPlanes.MAX_AGE_US);
            parameters.put("refractory-us", LocalPlanes.REFRACTORY_US);
            parameters.put("max-distance", LocalPlanes.MAX_DISTANCE);
            parameters.put("min-slope", LocalPlanes.MIN_SLOPE);
            return new MethodChoice(method.toString(), "", parameters, (sensor, ended) -> new LocalPlanes(sensor));
        }
        LucasKanadeDerivative chosen = derivative == null ? LucasKanadeDerivative.SAVITZKY_GOLAY : derivative;
        parameters.put("window-radius", LucasKanade.WINDOW_RADIUS);
        parameters.put("max-age-us", LucasKanade.MAX_AGE_US);
        parameters.put("min-eigenvalue", LucasKanade.MIN_EIGENVALUE);
        parameters.put("derivative", chosen.toString());
        return new MethodChoice(method.toString(), "", parameters,
            (sensor, ended) -> new LucasKanade(sensor, chosen.derivative));
    }

    /** Refuses the options that only SOFAS has; called if another method was chosen. */
    private void refuseParametersOfSofas() {
        refuse(ofSofas(), "needs --method sofas but was used with " + method);
    }

    /**
     * Refuses every option that determines how events are labelled.
     *
     * @param instead option with which they are not labelled
     * @throws ParameterException if such an option was given
     */
    void refuseLabelling(String instead) {
        List<String> labelling = ofSofas();
        labelling.addAll(List.of("--method", "--derivative", "--look-ahead", "--causal"));
        refuse(labelling, "has no effect with " + instead + ": the events are not labelled again");
    }

    private static List<String> ofSofas() {
        List<String> names = new ArrayList<>(List.of("--preset", "--config"));
        ParameterOptions.asMap(SofasParameters.defaults()).keySet().forEach(name -> names.add("--" + name));
        return names;
    }

    private void refuse(List<String> options, String why) {
        for (ArgSpec matched : command.commandLine().getParseResult().matchedArgs()) {
            if (matched instanceof OptionSpec && options.contains(((OptionSpec) matched).longestName())) {
                throw new ParameterException(command.commandLine(), ((OptionSpec) matched).longestName() + " " + why);
            }
        }
    }

    private static String hyphenated(Enum<?> constant) {
        return constant.name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
}
