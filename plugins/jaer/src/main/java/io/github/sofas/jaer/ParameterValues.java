package io.github.sofas.jaer;

import io.github.sofas.flow.Parameter;
import io.github.sofas.flow.SofasParameters;
import io.github.sofas.flow.SofasParameters.Preset;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * The parameters as the viewer's controls change them, one at a time and from any thread. Whatever is asked for, there
 * is always a valid record: a value outside its bounds, or beyond another parameter that bounds it, is moved to the
 * nearest bound.
 */
final class ParameterValues {
    private SofasParameters parameters;

    ParameterValues(SofasParameters parameters) {
        this.parameters = parameters;
    }

    /** The parameters of a preset. */
    static SofasParameters of(Preset preset) {
        return preset == Preset.PAPER ? SofasParameters.paper() : SofasParameters.defaults();
    }

    /** The components that are numbers or switches: all but the preset. */
    static List<RecordComponent> components() {
        List<RecordComponent> components = new ArrayList<>();
        for (RecordComponent component : SofasParameters.class.getRecordComponents()) {
            if (component.getType() != Preset.class) {
                components.add(component);
            }
        }
        return components;
    }

    /** The value of a component. */
    static Object value(RecordComponent component, SofasParameters of) {
        try {
            return component.getAccessor().invoke(of);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException("accessors of a public record can be called", e);
        }
    }

    synchronized SofasParameters parameters() {
        return parameters;
    }

    synchronized void setPreset(Preset preset) {
        parameters = of(preset);
    }

    synchronized void set(String name, boolean value) {
        parameters = with(name, value);
    }

    /**
     * Sets a number, moved into its bounds.
     *
     * @return what was wrong with the value, empty where it was taken as it is
     */
    synchronized String set(String name, double value) {
        RecordComponent component = component(name);
        double least = least(component);
        double most = most(component);
        double taken = value >= least ? Math.min(value, most) : least;
        try {
            parameters = with(name, boxed(component.getType(), taken));
        } catch (IllegalArgumentException e) {
            return e.getMessage() + "; left at " + plain(number(name));
        }
        return taken == value ? "" : String.format(Locale.ROOT, "%s must be between %s and %s but was %s; set to %s",
            name, plain(least), plain(most), plain(value), plain(number(name)));
    }

    synchronized double number(String name) {
        return ((Number) value(component(name), parameters)).doubleValue();
    }

    synchronized boolean isOn(String name) {
        return (Boolean) value(component(name), parameters);
    }

    private static RecordComponent component(String name) {
        for (RecordComponent component : SofasParameters.class.getRecordComponents()) {
            if (component.getName().equals(name)) {
                return component;
            }
        }
        throw new IllegalArgumentException("no parameter is called " + name);
    }

    private static Object boxed(Class<?> type, double value) {
        if (type == int.class) {
            return (int) value;
        }
        return type == long.class ? (Object) (long) value : (Object) value;
    }

    private SofasParameters with(String name, Object value) {
        String method = "with" + Character.toUpperCase(name.charAt(0)) + name.substring(1);
        try {
            return (SofasParameters) SofasParameters.class.getMethod(method, component(name).getType())
                .invoke(parameters, value);
        } catch (InvocationTargetException e) {
            throw new IllegalArgumentException(e.getCause().getMessage(), e);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException("every component can be replaced", e);
        }
    }

    private double least(RecordComponent component) {
        double least = component.getAnnotation(Parameter.class).min();
        return Math.max(least, switch (component.getName()) {
            case "maxLifetimePx" -> parameters.preset() == Preset.DEFAULT ? parameters.lifetimePx() : least;
            case "maxPerturbationDeg" -> parameters.minPerturbationDeg();
            case "maxStepPx" -> parameters.minStepPx();
            case "fastestPxPerS" -> 2 * parameters.slowestPxPerS();
            default -> least;
        });
    }

    private double most(RecordComponent component) {
        double most = component.getAnnotation(Parameter.class).max();
        return Math.min(most, switch (component.getName()) {
            case "lifetimePx" -> parameters.preset() == Preset.DEFAULT ? parameters.maxLifetimePx() : most;
            case "minPerturbationDeg" -> parameters.maxPerturbationDeg();
            case "minStepPx" -> parameters.maxStepPx();
            case "slowestPxPerS" -> parameters.fastestPxPerS() / 2;
            default -> most;
        });
    }

    /** What a control says of a parameter. */
    static String tooltip(RecordComponent component) {
        Parameter parameter = component.getAnnotation(Parameter.class);
        StringBuilder text = new StringBuilder("<html>").append(parameter.value()).append("<br>");
        if (component.getType() != boolean.class) {
            text.append(plain(parameter.min())).append(" to ").append(plain(parameter.max()));
            text.append(parameter.unit().isEmpty() ? "" : " " + parameter.unit()).append("; ");
        }
        text.append("default ").append(text(value(component, SofasParameters.defaults())));
        return text.append(", paper ").append(text(value(component, SofasParameters.paper()))).toString();
    }

    private static String text(Object value) {
        return value instanceof Number ? plain(((Number) value).doubleValue()) : value.toString();
    }

    private static String plain(double value) {
        return value == Math.rint(value) && Math.abs(value) < 1e15 ? Long.toString((long) value)
            : Double.toString(value);
    }
}
