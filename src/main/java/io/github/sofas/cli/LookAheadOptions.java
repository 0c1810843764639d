package io.github.sofas.cli;

import io.github.sofas.export.RunSummary;
import io.github.sofas.flow.SmoothedSofas;
import io.github.sofas.flow.SofasParameters;
import java.util.LinkedHashMap;
import java.util.Map;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/**
 * Options that determine whether labels depend on what comes after an event. Those of recordings do by default. Used
 * together with {@link MethodOptions}.
 */
final class LookAheadOptions {
    /** Name of the look-ahead in the parameters of results. */
    static final String PARAMETER = RunSummary.LOOK_AHEAD;
    /** Look-ahead of recordings unless the options say otherwise, in ms. */
    static final int DEFAULT_MS = 200;
    private static final int US_PER_MS = 1000;

    @Spec(Spec.Target.MIXEE)
    private CommandSpec command;

    @Option(names = "--look-ahead", paramLabel = "MS",
        description = "Label each event by what comes up to MS ms after it, too, 4 to 10000: velocities do not lag, "
            + "and events from before a structure was found are labelled. Default: " + DEFAULT_MS + " for recordings "
            + "that SOFAS labels with its default preset; none in 'experiments'.")
    private Integer lookAheadMs;

    @Option(names = "--causal", description = "Label each event by what came before it only, as a camera gets its "
        + "labels, in a third to nine tenths of the processor time.")
    private boolean causal;

    /** Whether the user asked for a look-ahead. */
    boolean isGiven() {
        return lookAheadMs != null;
    }

    /**
     * Returns a method for a recording: with the look-ahead that was asked for, else with the default one if the method
     * has it.
     *
     * @param parameters parameters of the method if that is SOFAS
     * @throws ParameterException if the method has no look-ahead, or the look-ahead is outside its range or not wanted
     */
    MethodChoice ofRecording(MethodChoice method, SofasParameters parameters) {
        boolean isDefault = lookAheadMs == null && !causal && isSofas(method)
            && parameters.preset() == SofasParameters.Preset.DEFAULT;
        return isDefault ? withLookAhead(method, parameters, "--look-ahead", DEFAULT_MS, command)
            : applyTo(method, parameters);
    }

    /** Returns a method with the look-ahead that was asked for, or without one if none was. */
    MethodChoice applyTo(MethodChoice method, SofasParameters parameters) {
        if (lookAheadMs == null) {
            return method;
        }
        if (causal) {
            throw new ParameterException(command.commandLine(), "--causal cannot be combined with --look-ahead");
        }
        return withLookAhead(method, parameters, "--look-ahead", lookAheadMs, command);
    }

    private static boolean isSofas(MethodChoice method) {
        return method.method().equals(MethodOptions.Method.SOFAS.toString());
    }

    /** Returns a method with the look-ahead that a given option asks for. */
    static MethodChoice withLookAhead(MethodChoice method, SofasParameters parameters, String option, int ms,
                                      CommandSpec command) {
        if (!isSofas(method)) {
            throw new ParameterException(command.commandLine(), option + " needs --method sofas but was used with "
                + method.method());
        }
        if (parameters.preset() != SofasParameters.Preset.DEFAULT) {
            throw new ParameterException(command.commandLine(), option + " needs --preset default but was used with "
                + method.preset());
        }
        long us = (long) ms * US_PER_MS;
        if (us < SmoothedSofas.MIN_LOOK_AHEAD_US || us > SmoothedSofas.MAX_LOOK_AHEAD_US) {
            throw new ParameterException(command.commandLine(), option + " must be "
                + SmoothedSofas.MIN_LOOK_AHEAD_US / US_PER_MS + " to " + SmoothedSofas.MAX_LOOK_AHEAD_US / US_PER_MS
                + " but was " + ms);
        }
        Map<String, Object> all = new LinkedHashMap<>(method.parameters());
        all.put(PARAMETER, ms);
        return new MethodChoice(method.method(), method.preset(), all, method.maker(),
            (sensor, ended) -> new SmoothedSofas(sensor, parameters, us, ended));
    }
}
