package io.github.sofas.flow;

import java.util.Map;

/**
 * Every parameter of the method, immutable and checked, grouped by subject. A parameter is declared here and nowhere
 * else, with its meaning, unit, range and value in both presets ({@link Parameter}). A number that is to be the same
 * for all recordings is not a parameter, but a constant of the class that uses it.
 *
 * <pre>{@code
 * SofasParameters.defaults().with("lifetimePx", 3).with("rotation", false)
 * }</pre>
 *
 * <p>There are two presets: {@link #paper()} is the method as published, {@link #defaults()} the most accurate and
 * fastest one. A parameter that has a value in only one of them is used by that one only.
 *
 * @param preset which of the two methods the other parameters are for
 * @param search how new structures are looked for
 * @param track how structures are tracked
 * @param published what only the paper preset needs
 */
public record SofasParameters(
    Preset preset,
    @Parameter.Group("flow plane") Search search,
    @Parameter.Group("track planes") Track track,
    @Parameter.Group("paper preset only") Published published) {

    /**
     * The presets, made once: making one takes reflection, and a command asks for them once for each of its parameters.
     */
    private static final Map<Preset, SofasParameters> PRESETS = Map.of(
        Preset.PAPER, ParameterHandle.preset(Preset.PAPER), Preset.DEFAULT, ParameterHandle.preset(Preset.DEFAULT));

    /** The method that labels events. */
    public enum Preset {
        /** As published: nearest cells, signed votes, hits. */
        PAPER,
        /** Ours: the same nouns, made accurate and fast. */
        DEFAULT
    }

    /** How new structures are looked for (paper, section Flow Plane). */
    public record Search(
        @Parameter(value = "projections of the flow plane along each of its two axes",
            origin = "n of the paper's flow plane; default: rings of speed, and directions a ring",
            min = 3, max = 31, defaults = 9, paper = 9)
        int flowProjections,
        @Parameter(value = "speed of the slowest ring",
            origin = "ours, because evenly spaced angles leave slow objects between two projections",
            unit = "px/s", min = 0.1, max = 1000, defaults = 4)
        double slowestPxPerS,
        @Parameter(value = "speed of the fastest ring", origin = "ours, as the slowest",
            unit = "px/s", min = 1, max = 100_000, defaults = 1500, atLeast = "slowestPxPerS", times = 2)
        double fastestPxPerS,
        @Parameter(value = "longest time that an event stays in the flow plane",
            origin = "paper, Flow Plane, without a number",
            unit = "us", min = 1000, max = 60_000_000, defaults = 1_500_000, paper = 200_000)
        long lifespanUs,
        @Parameter(value = "standard deviations above the mean at which a cell selects its events",
            origin = "w of the paper's flow plane, without a number",
            min = 0, max = 10, defaults = 0.5, paper = 1)
        double thresholdSd,
        @Parameter(value = "fewest events of a structure", origin = "ours, because a handful of events has no velocity",
            min = 8, max = 100_000, defaults = 40, paper = 40)
        int minEvents,
        @Parameter(value = "metric per event that a structure needs",
            origin = "ours, because sliding an edge along itself at any speed is rewarded while counts are small",
            min = 0, max = 1000, defaults = 2.5)
        double evidence) {
    }

    /** How structures are tracked (paper, section Track Plane). */
    public record Track(
        @Parameter(value = "travel after which an event leaves a track plane",
            origin = "p of the paper's track plane; default: while the velocity changes",
            unit = "px", min = 1, max = 100, defaults = 5, paper = 3)
        double lifetimePx,
        @Parameter(value = "lifetime that a steady velocity grows to",
            origin = "ours, because the spread of the velocity falls with the window",
            unit = "px", min = 1, max = 100, defaults = 16, atLeast = "lifetimePx")
        double maxLifetimePx,
        @Parameter(value = "travel for which a track plane remembers where its contour was",
            origin = "ours, because an edge that was hidden, or that moved along itself, would come back as another",
            unit = "px", min = 0, max = 1000, defaults = 64)
        double memoryPx,
        @Parameter(value = "whether a track plane may accelerate",
            origin = "ours, because the velocity of now is wanted, not that of the middle of the window",
            defaults = Parameter.ON)
        boolean acceleration,
        @Parameter(value = "whether a track plane may turn", origin = "ours, because a pendulum and a bar turn",
            defaults = Parameter.ON)
        boolean rotation,
        @Parameter(value = "whether a track plane may grow", origin = "ours, because what comes near does",
            defaults = Parameter.ON)
        boolean growth,
        @Parameter(value = "most track planes at once", origin = "ours, because memory is to be bounded",
            min = 1, max = 64, defaults = 64, paper = 64)
        int maxTrackPlanes,
        @Parameter(value = "share of the expected events below which a track plane is removed",
            origin = "n of the paper, section Algorithm, without a number",
            min = 0, max = 1, defaults = 0.3, paper = 0.2)
        double minShare) {
    }

    /** What only the paper preset needs. */
    public record Published(
        @Parameter(value = "speed of a projection at 45 degrees",
            origin = "ours, because the paper leaves the unit of time open",
            unit = "px/s", min = 1, max = 10_000, paper = 100)
        double velocityScalePxPerS,
        @Parameter(value = "events for which the greatest metric stays with one projection",
            origin = "p of the paper's flow plane, without a number",
            min = 1, max = 100_000, paper = 300)
        int constantEvents) {
    }

    /**
     * Checks every parameter.
     *
     * @param preset which of the two methods the other parameters are for
     * @param search how new structures are looked for
     * @param track how structures are tracked
     * @param published what only the paper preset needs
     * @throws IllegalArgumentException if a parameter is outside its range; the message names it
     */
    public SofasParameters {
        if (preset == null) {
            throw new IllegalArgumentException("preset must be paper or default but was null");
        }
        ParameterHandle.check(preset, search, track, published);
    }

    /** {@return the method as published (Stoffregen and Kleeman, ACRA 2017); where the paper gives no number, ours} */
    public static SofasParameters paper() {
        return of(Preset.PAPER);
    }

    /** {@return the most accurate preset, and the one to start from} */
    public static SofasParameters defaults() {
        return of(Preset.DEFAULT);
    }

    /**
     * {@return the parameters of a preset}
     *
     * @param preset the preset
     */
    public static SofasParameters of(Preset preset) {
        return PRESETS.get(preset);
    }

    /**
     * {@return the same parameters with another value of one number}
     *
     * @param name of a parameter, such as {@code lifetimePx}
     * @param value its new value
     * @throws IllegalArgumentException if no parameter has that name, it is a switch, or the value is outside its range
     */
    public SofasParameters with(String name, double value) {
        return with(Map.of(name, value));
    }

    /**
     * {@return the same parameters with another position of one switch}
     *
     * @param name of a parameter, such as {@code rotation}
     * @param value its new value
     * @throws IllegalArgumentException if no parameter has that name, or it is a number
     */
    public SofasParameters with(String name, boolean value) {
        return with(Map.of(name, value));
    }

    /**
     * {@return the same parameters with other values of several, which may bound each other}
     *
     * @param values a Number or a Boolean by the name of its parameter
     * @throws IllegalArgumentException if no parameter has one of the names, or a value is wrong
     */
    public SofasParameters with(Map<String, ?> values) {
        return ParameterHandle.set(this, values);
    }
}
