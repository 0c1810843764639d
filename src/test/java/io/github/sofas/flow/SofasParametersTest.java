package io.github.sofas.flow;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNotEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.List;
import org.junit.Test;

public class SofasParametersTest {
    /** Component, paper, default; in the record's order. */
    private static final String PINNED = """
        preset PAPER DEFAULT
        flowProjections 9 9
        velocityScalePxPerS 100.0 100.0
        rangeDeg 180.0 180.0
        refinement 9.0 9.0
        cycles 3 3
        constantEvents 300 300
        slowestPxPerS 4.0 4.0
        fastestPxPerS 1500.0 1500.0
        flowTravelPx 6.0 6.0
        lifespanUs 200000 1500000
        thresholdSd 1.0 0.5
        minEvents 40 40
        evidence 0.0 2.5
        slowestWithin 0.03 0.03
        lifetimePx 3.0 5.0
        maxLifetimePx 3.0 16.0
        maxLifetimeUs 1000000 1000000
        steadyPx 0.15 0.15
        hitShare 0.1 0.1
        minPerturbationDeg 0.05 0.05
        maxPerturbationDeg 4.0 4.0
        contourThreshold 3 3
        contourShare 0.15 0.15
        memoryPx 0.0 64.0
        maxMemoryUs 0 2000000
        voteCellPx 1.3 1.3
        sampleEvents 2000 1000
        sampleDensity 1.5 1.5
        neighbourLoss 0.04 0.04
        minStepPx 0.5 0.5
        maxStepPx 4.0 4.0
        flatSigmas 2.0 2.0
        stiffness 0.002 0.002
        sharedScore 0.5 0.5
        foresight 1.0 1.0
        maxBendPx 0.25 0.25
        flatChange 0.1 0.1
        rotation false true
        changePx 1.5 1.5
        changeGain 0.5 0.5
        bendPx 0.07 0.07
        flatDecay 0.05 0.05
        maxShared 0.15 0.15
        maxTrackPlanes 64 64
        minShare 0.2 0.3
        mergeVelocity 0.15 0.15
        mergeLoss 0.02 0.02
        mergeGapShare 0.8 0.8
        """;

    private static final List<RecordComponent> NUMBERS = new ArrayList<>();

    static {
        for (RecordComponent component : SofasParameters.class.getRecordComponents()) {
            if (component.getAnnotation(Parameter.class) != null && component.getType() != boolean.class) {
                NUMBERS.add(component);
            }
        }
    }

    @Test
    public void presetsAreWhatTheyAre() {
        StringBuilder table = new StringBuilder();
        for (RecordComponent c : SofasParameters.class.getRecordComponents()) {
            table.append(c.getName()).append(' ').append(get(SofasParameters.paper(), c)).append(' ')
                .append(get(SofasParameters.defaults(), c)).append('\n');
        }
        assertEquals(PINNED, table.toString());
    }

    @Test
    public void everyComponentButThePresetIsDescribed() {
        for (RecordComponent c : SofasParameters.class.getRecordComponents()) {
            Parameter parameter = c.getAnnotation(Parameter.class);
            assertEquals(c.getName(), c.getType() == SofasParameters.Preset.class, parameter == null);
            if (parameter != null) {
                assertFalse(c.getName(), parameter.value().isBlank());
                assertEquals(c.getName(), unitInName(c.getName()), parameter.unit());
                assertTrue(c.getName(), parameter.min() < parameter.max());
            }
        }
    }

    private static String unitInName(String name) {
        return name.endsWith("PxPerS") ? "px/s" : name.endsWith("Px") ? "px" : name.endsWith("Us") ? "us"
            : name.endsWith("Deg") ? "degrees" : "";
    }

    @Test
    public void bothBoundsAreAllowed() {
        for (RecordComponent c : NUMBERS) {
            Parameter range = c.getAnnotation(Parameter.class);
            assertEquals(c.getName(), number(c, range.min()), get(allowing(c, range.min()), c));
            assertEquals(c.getName(), number(c, range.max()), get(allowing(c, range.max()), c));
        }
    }

    @Test
    public void theNextValueBeyondEachBoundIsRefused() {
        for (RecordComponent c : NUMBERS) {
            Parameter range = c.getAnnotation(Parameter.class);
            boolean whole = c.getType() != double.class;
            assertRefused(c, whole ? range.min() - 1 : Math.nextDown(range.min()));
            assertRefused(c, whole ? range.max() + 1 : Math.nextUp(range.max()));
        }
    }

    @Test
    public void whatIsNoNumberIsRefused() {
        for (RecordComponent c : NUMBERS) {
            if (c.getType() == double.class) {
                assertRefused(c, Double.NaN);
                assertRefused(c, Double.POSITIVE_INFINITY);
                assertRefused(c, Double.NEGATIVE_INFINITY);
            }
        }
    }

    private static void assertRefused(RecordComponent c, double value) {
        Parameter range = c.getAnnotation(Parameter.class);
        for (SofasParameters base : List.of(SofasParameters.paper(), SofasParameters.defaults())) {
            IllegalArgumentException e =
                assertThrows(c.getName(), IllegalArgumentException.class, () -> with(base, c, number(c, value)));
            assertEquals(c.getName() + " must be between " + text(range.min()) + " and " + text(range.max())
                + " but was " + text(value), e.getMessage());
        }
    }

    /** A whole number without ".0". */
    private static String text(double value) {
        return value == Math.rint(value) && Double.isFinite(value) ? String.valueOf((long) value)
            : String.valueOf(value);
    }

    @Test
    public void missingPresetIsRefused() {
        Object[] values = values(SofasParameters.paper());
        values[0] = null;
        assertEquals("preset must be paper or default but was null",
            assertThrows(IllegalArgumentException.class, () -> make(values)).getMessage());
    }

    @Test
    public void fastestRingIsAtLeastTwiceAsFastAsTheSlowest() {
        SofasParameters p = SofasParameters.defaults().withSlowestPxPerS(10);
        assertEquals(20, p.withFastestPxPerS(20).fastestPxPerS(), 0);
        assertEquals("fastestPxPerS must be at least twice slowestPxPerS 10 but was 19.5",
            assertThrows(IllegalArgumentException.class, () -> p.withFastestPxPerS(19.5)).getMessage());
    }

    @Test
    public void lifetimeGrowsToNoLessThanItStartsWith() {
        SofasParameters p = SofasParameters.defaults().withMaxLifetimePx(8);
        assertEquals(8, p.withLifetimePx(8).lifetimePx(), 0);
        assertEquals("maxLifetimePx must be at least lifetimePx 8.5 but was 8",
            assertThrows(IllegalArgumentException.class, () -> p.withLifetimePx(8.5)).getMessage());
    }

    @Test
    public void changingOneComponentLeavesTheOthers() {
        for (RecordComponent c : SofasParameters.class.getRecordComponents()) {
            Parameter range = c.getAnnotation(Parameter.class);
            if (range == null) {
                continue;
            }
            if (c.getType() == boolean.class) {
                assertChangesOnly(c, SofasParameters.defaults(), !(boolean) get(SofasParameters.defaults(), c));
            } else {
                assertChangesOnly(c, baseAllowing(c, range.min()), number(c, range.min()));
                assertChangesOnly(c, baseAllowing(c, range.max()), number(c, range.max()));
            }
        }
    }

    private static void assertChangesOnly(RecordComponent changed, SofasParameters base, Object value) {
        Object[] expected = values(base);
        RecordComponent[] components = SofasParameters.class.getRecordComponents();
        for (int i = 0; i < components.length; i++) {
            if (components[i].getName().equals(changed.getName())) {
                expected[i] = value;
            }
        }
        SofasParameters result = with(base, changed, value);
        assertEquals(changed.getName(), List.of(expected), List.of(values(result)));
        assertEquals(changed.getName(), make(expected), result);
    }

    @Test
    public void presetsDiffer() {
        assertNotEquals(SofasParameters.paper(), SofasParameters.defaults());
    }

    private static SofasParameters allowing(RecordComponent c, double value) {
        return with(baseAllowing(c, value), c, number(c, value));
    }

    /** Parameters under which a value breaks no rule between two components: others at their least, or greatest. */
    private static SofasParameters baseAllowing(RecordComponent c, double value) {
        List<SofasParameters> bases = List.of(SofasParameters.defaults(), atBounds(true), atBounds(false));
        IllegalArgumentException refused = null;
        for (SofasParameters base : bases) {
            try {
                with(base, c, number(c, value));
                return base;
            } catch (IllegalArgumentException e) {
                refused = e;
            }
        }
        throw refused;
    }

    private static SofasParameters atBounds(boolean least) {
        RecordComponent[] components = SofasParameters.class.getRecordComponents();
        Object[] values = values(SofasParameters.defaults());
        for (int i = 0; i < components.length; i++) {
            Parameter range = components[i].getAnnotation(Parameter.class);
            if (values[i] instanceof Number) {
                values[i] = number(components[i], least ? range.min() : range.max());
            }
        }
        return make(values);
    }

    private static Object number(RecordComponent c, double value) {
        if (c.getType() == int.class) {
            return (int) value;
        }
        return c.getType() == long.class ? (Object) (long) value : (Object) value;
    }

    private static Object get(SofasParameters p, RecordComponent c) {
        try {
            return c.getAccessor().invoke(p);
        } catch (ReflectiveOperationException e) {
            throw new AssertionError(c.getName(), e);
        }
    }

    private static Object[] values(SofasParameters p) {
        RecordComponent[] components = SofasParameters.class.getRecordComponents();
        Object[] values = new Object[components.length];
        for (int i = 0; i < values.length; i++) {
            values[i] = get(p, components[i]);
        }
        return values;
    }

    private static SofasParameters make(Object[] values) {
        RecordComponent[] components = SofasParameters.class.getRecordComponents();
        Class<?>[] types = new Class<?>[components.length];
        for (int i = 0; i < types.length; i++) {
            types[i] = components[i].getType();
        }
        try {
            return SofasParameters.class.getDeclaredConstructor(types).newInstance(values);
        } catch (InvocationTargetException e) {
            throw (IllegalArgumentException) e.getCause();
        } catch (ReflectiveOperationException e) {
            throw new AssertionError(e);
        }
    }

    private static SofasParameters with(SofasParameters p, RecordComponent c, Object value) {
        String method = "with" + Character.toUpperCase(c.getName().charAt(0)) + c.getName().substring(1);
        try {
            return (SofasParameters) SofasParameters.class.getMethod(method, c.getType()).invoke(p, value);
        } catch (InvocationTargetException e) {
            throw (IllegalArgumentException) e.getCause();
        } catch (ReflectiveOperationException e) {
            throw new AssertionError(method, e);
        }
    }
}
