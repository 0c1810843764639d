package io.github.sofas.flow;

import io.github.sofas.flow.SofasParameters.Preset;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * One parameter of {@link SofasParameters}: its declaration, and its value in a given set of parameters. For programs
 * that show or set parameters without knowing each of them.
 */
public final class ParameterHandle {
    private static final List<ParameterHandle> ALL = find();

    private final RecordComponent group;
    private final RecordComponent component;
    private final Parameter declaration;

    private ParameterHandle(RecordComponent group, RecordComponent component) {
        this.group = group;
        this.component = component;
        declaration = component.getAnnotation(Parameter.class);
    }

    private static List<ParameterHandle> find() {
        List<ParameterHandle> found = new ArrayList<>();
        for (RecordComponent group : SofasParameters.class.getRecordComponents()) {
            if (group.getType().isRecord()) {
                for (RecordComponent component : group.getType().getRecordComponents()) {
                    found.add(new ParameterHandle(group, component));
                }
            }
        }
        return List.copyOf(found);
    }

    /** {@return every parameter except the preset, group by group} */
    public static List<ParameterHandle> all() {
        return ALL;
    }

    /**
     * {@return the parameter with a name}
     *
     * @param name such as {@code lifetimePx}
     * @throws IllegalArgumentException if no parameter has that name
     */
    public static ParameterHandle named(String name) {
        for (ParameterHandle each : ALL) {
            if (each.name().equals(name)) {
                return each;
            }
        }
        StringBuilder known = new StringBuilder();
        for (ParameterHandle each : ALL) {
            known.append(known.length() == 0 ? "" : ", ").append(each.name());
        }
        throw new IllegalArgumentException("no parameter is called \"" + name + "\"; there are " + known);
    }

    /** {@return its name, such as {@code lifetimePx}} */
    public String name() {
        return component.getName();
    }

    /** {@return the subject of the group that it belongs to} */
    public String group() {
        return group.getAnnotation(Parameter.Group.class).value();
    }

    /** {@return its declaration} */
    public Parameter declaration() {
        return declaration;
    }

    /** {@return whether it is a switch, true or false, not a number} */
    public boolean isSwitch() {
        return component.getType() == boolean.class;
    }

    /** {@return whether it takes whole numbers only} */
    public boolean isWhole() {
        return component.getType() == int.class || component.getType() == long.class;
    }

    /**
     * {@return whether a preset makes use of it}
     *
     * @param preset the preset
     */
    public boolean isUsedBy(Preset preset) {
        return !Double.isNaN(declared(preset));
    }

    private double declared(Preset preset) {
        return preset == Preset.PAPER ? declaration.paper() : declaration.defaults();
    }

    /**
     * {@return its value: a Boolean, Integer, Long or Double}
     *
     * @param parameters where it is looked up
     */
    public Object get(SofasParameters parameters) {
        return value(component, value(group, parameters));
    }

    /**
     * {@return its value as a number; for a switch, {@link Parameter#ON} or {@link Parameter#OFF}}
     *
     * @param parameters where it is looked up
     */
    public double number(SofasParameters parameters) {
        Object value = get(parameters);
        return value instanceof Boolean ? (Boolean) value ? Parameter.ON : Parameter.OFF
            : ((Number) value).doubleValue();
    }

    /**
     * {@return the smallest value that it takes while the others stay as they are}
     *
     * @param parameters where it is looked up
     */
    public double least(SofasParameters parameters) {
        double least = declaration.min();
        return declaration.atLeast().isEmpty() || !isUsedBy(parameters.preset()) ? least
            : Math.max(least, declaration.times() * named(declaration.atLeast()).number(parameters));
    }

    /**
     * {@return the greatest value that it takes while the others stay as they are}
     *
     * @param parameters where it is looked up
     */
    public double most(SofasParameters parameters) {
        double most = declaration.max();
        for (ParameterHandle each : ALL) {
            if (each.declaration.atLeast().equals(name()) && each.isUsedBy(parameters.preset())) {
                most = Math.min(most, each.number(parameters) / each.declaration.times());
            }
        }
        return most;
    }

    /** The same parameters with other values, given by name. */
    static SofasParameters set(SofasParameters parameters, Map<String, ?> values) {
        Map<String, Object> boxed = new HashMap<>();
        values.forEach((name, value) -> boxed.put(name, named(name).checked(value)));
        return (SofasParameters) make(SofasParameters.class, group -> group.getType().isRecord()
            ? make(group.getType(), component -> boxed.getOrDefault(component.getName(),
                value(component, value(group, parameters)))) : value(group, parameters));
    }

    /** A value in the type of the parameter, if the parameter can take it. */
    private Object checked(Object value) {
        if (isSwitch() || !(value instanceof Number)) {
            if (isSwitch() && value instanceof Boolean) {
                return value;
            }
            throw new IllegalArgumentException(name() + " must be " + (isSwitch() ? "true or false" : "a number")
                + " but was " + (value instanceof Number ? plain(((Number) value).doubleValue()) : value));
        }
        double number = ((Number) value).doubleValue();
        checkRange(number);
        if (isWhole() && number != Math.rint(number)) {
            throw new IllegalArgumentException(name() + " must be a whole number but was " + plain(number));
        }
        return boxed(number);
    }

    /**
     * The parameters of a preset, as declared; one that the preset does not use takes its value from the other preset.
     */
    static SofasParameters preset(Preset preset) {
        return (SofasParameters) make(SofasParameters.class, group -> group.getType().isRecord()
            ? make(group.getType(), component -> new ParameterHandle(group, component).valueIn(preset)) : preset);
    }

    private Object valueIn(Preset preset) {
        double value = declared(preset);
        return boxed(Double.isNaN(value) ? declared(preset == Preset.PAPER ? Preset.DEFAULT : Preset.PAPER) : value);
    }

    /** Checks the ranges, and the bounds between parameters. */
    static void check(Preset preset, Record... groups) {
        for (ParameterHandle each : ALL) {
            if (!each.isSwitch()) {
                each.checkRange(each.number(groups));
            }
        }
        for (ParameterHandle each : ALL) {
            if (!each.declaration.atLeast().isEmpty() && each.isUsedBy(preset)) {
                each.checkBound(groups);
            }
        }
    }

    private double number(Record[] groups) {
        for (Record each : groups) {
            if (each != null && each.getClass() == group.getType()) {
                return ((Number) value(component, each)).doubleValue();
            }
        }
        throw new IllegalArgumentException(group.getName() + " must be given but was null");
    }

    private void checkRange(double value) {
        if (!(value >= declaration.min() && value <= declaration.max())) {
            throw new IllegalArgumentException(name() + " must be between " + plain(declaration.min()) + " and "
                + plain(declaration.max()) + " but was " + plain(value));
        }
    }

    private void checkBound(Record[] groups) {
        double value = number(groups);
        double bound = named(declaration.atLeast()).number(groups);
        double times = declaration.times();
        if (value < times * bound) {
            throw new IllegalArgumentException(name() + " must be at least "
                + (times == 1 ? "" : times == 2 ? "twice " : plain(times) + " times ") + declaration.atLeast() + " "
                + plain(bound) + " but was " + plain(value));
        }
    }

    private Object boxed(double value) {
        Class<?> type = component.getType();
        if (type == boolean.class) {
            return value == Parameter.ON;
        } else if (type == int.class) {
            return (int) value;
        }
        return type == long.class ? (Object) (long) value : (Object) value;
    }

    private static String plain(double value) {
        return value == Math.rint(value) && Math.abs(value) < 1e15 ? Long.toString((long) value)
            : Double.toString(value);
    }

    private static Object value(RecordComponent of, Object record) {
        try {
            return of.getAccessor().invoke(record);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException("accessors of a public record can be called", e);
        }
    }

    private interface Values {
        Object of(RecordComponent component);
    }

    private static Object make(Class<?> type, Values values) {
        RecordComponent[] components = type.getRecordComponents();
        Class<?>[] types = new Class<?>[components.length];
        Object[] arguments = new Object[components.length];
        for (int i = 0; i < components.length; i++) {
            types[i] = components[i].getType();
            arguments[i] = values.of(components[i]);
        }
        try {
            return type.getConstructor(types).newInstance(arguments);
        } catch (InvocationTargetException e) {
            throw (IllegalArgumentException) e.getCause();
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException("the constructor of a public record can be called", e);
        }
    }
}
