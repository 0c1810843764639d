package io.github.sofas.jaer;

import io.github.sofas.flow.Parameter;
import io.github.sofas.flow.ParameterHandle;
import io.github.sofas.flow.SofasParameters;
import io.github.sofas.flow.SofasParameters.Preset;
import java.util.List;
import java.util.Locale;

/**
 * The parameters as the viewer's controls change them: one at a time, and from any thread. The record of parameters is
 * always valid, whatever value is requested. A value outside its bounds, or beyond another parameter that bounds it, is
 * moved to the nearest bound.
 */
final class ParameterValues {
    private SofasParameters parameters;

    ParameterValues(SofasParameters parameters) {
        this.parameters = parameters;
    }

    synchronized SofasParameters parameters() {
        return parameters;
    }

    synchronized void setPreset(Preset preset) {
        parameters = SofasParameters.of(preset);
    }

    synchronized void set(String name, boolean value) {
        parameters = parameters.with(name, value);
    }

    /**
     * Sets a number, moved into its bounds.
     *
     * @return a message on what was wrong with the value; empty if the value was taken as it is
     */
    synchronized String set(String name, double value) {
        ParameterHandle handle = ParameterHandle.named(name);
        double least = handle.least(parameters);
        double most = handle.most(parameters);
        double taken = value >= least ? Math.min(value, most) : least;
        try {
            parameters = parameters.with(name, handle.isWhole() ? Math.floor(taken) : taken);
        } catch (IllegalArgumentException e) {
            return e.getMessage() + "; left at " + plain(number(name));
        }
        return taken == value ? "" : String.format(Locale.ROOT, "%s must be between %s and %s but was %s; set to %s",
            name, plain(least), plain(most), plain(value), plain(number(name)));
    }

    synchronized double number(String name) {
        return ParameterHandle.named(name).number(parameters);
    }

    synchronized boolean isOn(String name) {
        return number(name) == Parameter.ON;
    }

    /** The tooltip of a parameter's control. */
    static String tooltip(ParameterHandle handle) {
        Parameter parameter = handle.declaration();
        StringBuilder text = new StringBuilder("<html>").append(parameter.value()).append("<br>");
        if (!handle.isSwitch()) {
            text.append(plain(parameter.min())).append(" to ").append(plain(parameter.max()));
            text.append(parameter.unit().isEmpty() ? "" : " " + parameter.unit()).append("; ");
        }
        String separator = "";
        for (Preset preset : List.of(Preset.DEFAULT, Preset.PAPER)) {
            if (handle.isUsedBy(preset)) {
                text.append(separator).append(preset.name().toLowerCase(Locale.ROOT)).append(' ')
                    .append(text(handle.get(SofasParameters.of(preset))));
                separator = ", ";
            }
        }
        return text.toString();
    }

    private static String text(Object value) {
        return value instanceof Number ? plain(((Number) value).doubleValue()) : value.toString();
    }

    private static String plain(double value) {
        return value == Math.rint(value) && Math.abs(value) < 1e15 ? Long.toString((long) value)
            : Double.toString(value);
    }
}
