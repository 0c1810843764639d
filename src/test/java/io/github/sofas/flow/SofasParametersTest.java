package io.github.sofas.flow;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNotEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.Test;

public class SofasParametersTest {
    /** Name, value by default, value of the paper preset or "-" where it makes no use of it; in the order of help. */
    private static final String PINNED = """
        flowProjections 9 9
        slowestPxPerS 4.0 -
        fastestPxPerS 1500.0 -
        lifespanUs 1500000 200000
        thresholdSd 0.5 1.0
        minEvents 40 40
        evidence 2.5 -
        lifetimePx 5.0 3.0
        maxLifetimePx 16.0 -
        memoryPx 64.0 -
        acceleration true -
        rotation true -
        growth true -
        maxTrackPlanes 64 64
        minShare 0.3 0.2
        velocityScalePxPerS - 100.0
        constantEvents - 300
        """;
    /** As many as people can hold in their heads. */
    private static final int MOST = 20;
    private static final List<SofasParameters> PRESETS = List.of(SofasParameters.paper(), SofasParameters.defaults());
    private static final List<ParameterHandle> NUMBERS = ParameterHandle.all().stream()
        .filter(handle -> !handle.isSwitch()).toList();

    @Test
    public void presetsAreWhatTheyAre() {
        StringBuilder table = new StringBuilder();
        for (ParameterHandle handle : ParameterHandle.all()) {
            table.append(handle.name()).append(' ').append(inPreset(handle, SofasParameters.defaults())).append(' ')
                .append(inPreset(handle, SofasParameters.paper())).append('\n');
        }
        assertEquals(PINNED, table.toString());
        assertEquals(SofasParameters.Preset.PAPER, SofasParameters.paper().preset());
        assertEquals(SofasParameters.Preset.DEFAULT, SofasParameters.defaults().preset());
    }

    private static Object inPreset(ParameterHandle handle, SofasParameters preset) {
        return handle.isUsedBy(preset.preset()) ? handle.get(preset) : "-";
    }

    @Test
    public void valueThatAPresetMakesNoUseOfIsThatOfTheOther() {
        for (ParameterHandle handle : ParameterHandle.all()) {
            if (!handle.isUsedBy(SofasParameters.Preset.PAPER)) {
                assertEquals(handle.name(), handle.get(SofasParameters.defaults()),
                    handle.get(SofasParameters.paper()));
            }
        }
    }

    @Test
    public void thereAreNoMoreThanPeopleCanHoldInTheirHeads() {
        assertTrue(ParameterHandle.all().size() <= MOST);
    }

    @Test
    public void everyParameterIsDescribedAndOfAPreset() {
        Set<String> names = new HashSet<>();
        for (ParameterHandle handle : ParameterHandle.all()) {
            Parameter parameter = handle.declaration();
            String name = handle.name();
            assertTrue(name + " twice", names.add(name));
            assertFalse(name, parameter.value().isBlank());
            assertTrue(name, parameter.origin().startsWith("ours, ") || parameter.origin().contains("paper"));
            assertEquals(name, unitInName(name), parameter.unit());
            assertTrue(name, parameter.min() < parameter.max());
            assertTrue(name, List.of(SofasParameters.Preset.values()).stream().anyMatch(handle::isUsedBy));
            assertFalse(name, handle.group().isBlank());
        }
    }

    private static String unitInName(String name) {
        return name.endsWith("PxPerS") ? "px/s" : name.endsWith("Px") ? "px" : name.endsWith("Us") ? "us"
            : name.endsWith("Deg") ? "degrees" : "";
    }

    @Test
    public void bothBoundsAreAllowed() {
        for (ParameterHandle handle : NUMBERS) {
            Parameter range = handle.declaration();
            for (double bound : new double[] {range.min(), range.max()}) {
                SofasParameters p = baseAllowing(handle, bound).with(handle.name(), bound);
                assertEquals(handle.name(), bound, handle.number(p), 0);
            }
        }
    }

    @Test
    public void theNextValueBeyondEachBoundIsRefused() {
        for (ParameterHandle handle : NUMBERS) {
            Parameter range = handle.declaration();
            assertRefused(handle, handle.isWhole() ? range.min() - 1 : Math.nextDown(range.min()));
            assertRefused(handle, handle.isWhole() ? range.max() + 1 : Math.nextUp(range.max()));
        }
    }

    @Test
    public void whatIsNoNumberIsRefused() {
        for (ParameterHandle handle : NUMBERS) {
            assertRefused(handle, Double.NaN);
            assertRefused(handle, Double.POSITIVE_INFINITY);
            assertRefused(handle, Double.NEGATIVE_INFINITY);
        }
    }

    private static void assertRefused(ParameterHandle handle, double value) {
        Parameter range = handle.declaration();
        for (SofasParameters base : PRESETS) {
            assertMessage(handle.name() + " must be between " + text(range.min()) + " and " + text(range.max())
                + " but was " + text(value), () -> base.with(handle.name(), value));
        }
    }

    /** A whole number without ".0". */
    private static String text(double value) {
        return value == Math.rint(value) && Double.isFinite(value) ? String.valueOf((long) value)
            : String.valueOf(value);
    }

    private static void assertMessage(String message, org.junit.function.ThrowingRunnable refused) {
        assertEquals(message, assertThrows(message, IllegalArgumentException.class, refused).getMessage());
    }

    @Test
    public void valueOfTheWrongKindIsRefused() {
        SofasParameters p = SofasParameters.defaults();
        assertMessage("minEvents must be a whole number but was 40.5", () -> p.with("minEvents", 40.5));
        assertMessage("rotation must be true or false but was 1", () -> p.with("rotation", 1));
        assertMessage("lifetimePx must be a number but was true", () -> p.with("lifetimePx", true));
        assertTrue(assertThrows(IllegalArgumentException.class, () -> p.with("lifetime", 5)).getMessage()
            .startsWith("no parameter is called \"lifetime\"; there are flowProjections, slowestPxPerS, "));
    }

    @Test
    public void missingPresetOrGroupIsRefused() {
        SofasParameters p = SofasParameters.paper();
        assertMessage("preset must be paper or default but was null",
            () -> new SofasParameters(null, p.search(), p.track(), p.published()));
        assertMessage("track must be given but was null",
            () -> new SofasParameters(p.preset(), p.search(), null, p.published()));
    }

    @Test
    public void fastestRingIsAtLeastTwiceAsFastAsTheSlowest() {
        SofasParameters p = SofasParameters.defaults().with("slowestPxPerS", 10);
        assertEquals(20, p.with("fastestPxPerS", 20).search().fastestPxPerS(), 0);
        assertMessage("fastestPxPerS must be at least twice slowestPxPerS 10 but was 19.5",
            () -> p.with("fastestPxPerS", 19.5));
    }

    @Test
    public void lifetimeGrowsToNoLessThanItStartsWith() {
        SofasParameters p = SofasParameters.defaults().with("maxLifetimePx", 8);
        assertEquals(8, p.with("lifetimePx", 8).track().lifetimePx(), 0);
        assertMessage("maxLifetimePx must be at least lifetimePx 8.5 but was 8", () -> p.with("lifetimePx", 8.5));
        // the lifetime of the paper does not grow
        assertEquals(50, SofasParameters.paper().with("lifetimePx", 50).track().lifetimePx(), 0);
    }

    @Test
    public void valuesThatBoundEachOtherAreTakenTogether() {
        SofasParameters p = SofasParameters.defaults().with(Map.of("lifetimePx", 30, "maxLifetimePx", 40));
        assertEquals(30, p.track().lifetimePx(), 0);
        assertEquals(40, p.track().maxLifetimePx(), 0);
    }

    @Test
    public void boundsByOthersAreKnown() {
        SofasParameters p = SofasParameters.defaults();
        assertEquals(5, ParameterHandle.named("maxLifetimePx").least(p), 0);
        assertEquals(16, ParameterHandle.named("lifetimePx").most(p), 0);
        assertEquals(8, ParameterHandle.named("fastestPxPerS").least(p), 0);
        assertEquals(750, ParameterHandle.named("slowestPxPerS").most(p), 0);
        assertEquals(100, ParameterHandle.named("lifetimePx").most(SofasParameters.paper()), 0);
    }

    @Test
    public void changingOneParameterLeavesTheOthers() {
        for (ParameterHandle changed : ParameterHandle.all()) {
            SofasParameters base = SofasParameters.defaults();
            double value = changed.least(base);
            SofasParameters next = changed.isSwitch() ? base.with(changed.name(), !(boolean) changed.get(base))
                : base.with(changed.name(), value);
            for (ParameterHandle handle : ParameterHandle.all()) {
                if (handle == changed) {
                    assertNotEquals(handle.name(), handle.get(base), handle.get(next));
                } else {
                    assertEquals(handle.name(), handle.get(base), handle.get(next));
                }
            }
        }
    }

    @Test
    public void equalValuesAreEqual() {
        assertNotEquals(SofasParameters.paper(), SofasParameters.defaults());
        assertEquals(SofasParameters.defaults(), SofasParameters.of(SofasParameters.Preset.DEFAULT));
        assertEquals(SofasParameters.defaults(), SofasParameters.defaults().with("minEvents", 40));
    }

    /** Parameters under which a value breaks no rule between two: others at their least, or greatest. */
    private static SofasParameters baseAllowing(ParameterHandle handle, double value) {
        SofasParameters p = SofasParameters.defaults();
        if (handle.name().equals("lifetimePx") || handle.name().equals("maxLifetimePx")) {
            return p.with(Map.of("lifetimePx", 1, "maxLifetimePx", 100));
        }
        return value < 100 ? p.with("slowestPxPerS", 0.1) : p.with("fastestPxPerS", 100_000);
    }
}
