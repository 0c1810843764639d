package io.github.sofas.flow.paper;

import java.lang.reflect.RecordComponent;

/** Numbers of the published method, of which some are others. */
final class Changed {
    private Changed() {
    }

    /** The same numbers, but for pairs of a component's name and its value. */
    static Numbers of(Numbers numbers, Object... changes) {
        RecordComponent[] components = Numbers.class.getRecordComponents();
        Object[] values = new Object[components.length];
        Class<?>[] types = new Class<?>[components.length];
        try {
            for (int i = 0; i < components.length; i++) {
                types[i] = components[i].getType();
                values[i] = components[i].getAccessor().invoke(numbers);
                for (int c = 0; c < changes.length; c += 2) {
                    if (components[i].getName().equals(changes[c])) {
                        values[i] = boxed(types[i], (Number) changes[c + 1]);
                    }
                }
            }
            return Numbers.class.getDeclaredConstructor(types).newInstance(values);
        } catch (ReflectiveOperationException e) {
            throw new AssertionError(e);
        }
    }

    private static Object boxed(Class<?> type, Number value) {
        return type == int.class ? (Object) value.intValue() : type == long.class ? (Object) value.longValue()
            : (Object) value.doubleValue();
    }
}
