package io.github.sofas.flow;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.RecordComponent;

/**
 * Every parameter of the method, immutable and checked. Options of the command line and of the viewer map one to one
 * onto the components.
 *
 * <p>Two presets: {@link #paper()} is the method as published, {@link #defaults()} what is most accurate and fast.
 * Where a component serves one of them only, its description says so.
 *
 * @param preset which of the two methods the others belong to
 * @param flowProjections projections of the flow plane along each of its two axes, 3 to 31 (n of the paper's flow
 *     plane; {@code default}: rings of speed, and directions a ring)
 * @param velocityScalePxPerS speed of a projection at 45 degrees in px/s, 1 to 10000 (ours, because the paper leaves
 *     the unit of time open; {@code paper} only)
 * @param rangeDeg range of the flow plane's angles in degrees, 1 to 180 (r of the paper's flow plane; {@code paper}
 *     only)
 * @param refinement factor by which a refining cycle narrows the range, 1.5 to 100 (q of the paper's flow plane;
 *     {@code paper} only)
 * @param cycles refining cycles, the widest included, 1 to 6 (paper: 180, 20, 2.2 degrees; {@code paper} only)
 * @param constantEvents events for which the greatest metric stays with one projection, 1 to 100,000 (p of the
 *     paper's flow plane, which gives no number; {@code paper} only)
 * @param slowestPxPerS speed of the slowest ring in px/s, 0.1 to 1000 (ours, because evenly spaced angles leave slow
 *     objects between two projections; {@code default} only)
 * @param fastestPxPerS speed of the fastest ring in px/s, 1 to 100000 (ours, as above; {@code default} only)
 * @param flowTravelPx travel after which an event leaves a projection of the flow plane in px, 2 to 32 (ours, because
 *     one lifespan for all speeds is too long for fast and too short for slow objects; {@code default} only)
 * @param lifespanUs longest time that an event stays in the flow plane in us, 1000 to 60,000,000 (paper, Flow Plane,
 *     without a number)
 * @param thresholdSd standard deviations above the mean at which a cell selects its events, 0 to 10 (w of the paper's
 *     flow plane, without a number)
 * @param minEvents fewest events of a structure, 8 to 100,000 (ours, because a handful of events has no velocity)
 * @param evidence metric an event that a structure needs, 0 to 1000 (ours, because sliding an edge along itself at
 *     any speed is rewarded while counts are small; {@code default} only)
 * @param slowestWithin share of the metric within which the slowest velocity of a new structure is taken, 0 to 1
 *     (ours, because a straight edge then gets its normal flow instead of any speed along itself; {@code default}
 *     only)
 * @param lifetimePx travel after which an event leaves a track plane in px, 1 to 100 (p of the paper's track plane;
 *     {@code default}: the lifetime while the velocity changes)
 * @param maxLifetimePx lifetime that a steady velocity grows to in px, 1 to 100 (ours, because the spread of the
 *     velocity falls with the window; {@code default} only)
 * @param maxLifetimeUs longest lifetime in us, 1000 to 60,000,000 (ours, because a structure that stands still would
 *     keep its events for ever)
 * @param steadyPx correction over half the window below which a velocity is steady in px, 0 to 4 (ours, as above;
 *     {@code default} only)
 * @param hitShare share of its cells that a projection must hit to become the centre, 0.001 to 1 (paper, Track Plane;
 *     {@code paper} only)
 * @param minPerturbationDeg smallest angle between neighbouring projections in degrees, 0.001 to 10 (ours, because
 *     halving without end stops all tracking; {@code paper} only)
 * @param maxPerturbationDeg greatest angle between neighbouring projections in degrees, 0.01 to 45 (ours, as above;
 *     {@code paper} only)
 * @param contourThreshold missed events that make a cell contour, 1 to 1000 (paper, Track Plane, without a number;
 *     {@code paper} only)
 * @param contourShare share of the mean support that puts an event on the contour, 0 to 1 (ours, because a contour a
 *     pixel wide loses events to noise in time; {@code default} only)
 * @param memoryPx travel for which a track plane remembers where its contour was in px, 0 to 1000 (ours, because an
 *     edge that was hidden, or that moved along itself, would come back as a structure of its own; {@code default}
 *     only)
 * @param maxMemoryUs longest time for which it does in us, 0 to 60,000,000 (ours, because a structure that stands
 *     still would haunt its place; {@code default} only)
 * @param voteCellPx side of the cells that velocities are measured with in px, 0.5 to 8 (ours, because cells as large
 *     as pixels favour whole pixels of travel; {@code default} only)
 * @param sampleEvents events that a velocity is measured from, where they meet often, 32 to 16,384 (ours, because the
 *     cost of a measurement grows with them, and 1,000 reach half a percent; {@code default} only)
 * @param sampleDensity metric an event below which a sample is enlarged, 0 to 100 (ours, because thinning events
 *     thins their meetings by the square; {@code default} only)
 * @param neighbourLoss share of the metric that neighbouring projections are to lose, 0.001 to 1 (ours, in place of
 *     halving and doubling, because an edge is sharp across and flat along; {@code default} only)
 * @param minStepPx smallest distance of neighbouring projections over half the window in px, 0.05 to 4 (ours, because
 *     closer ones differ by noise only; {@code default} only)
 * @param maxStepPx greatest distance of neighbouring projections over half the window in px, 0.1 to 16 (ours, as
 *     above; {@code default} only)
 * @param flatSigmas standard deviations of the metric that neighbours must lose for a direction to take a step, 0 to
 *     100 (ours, because the velocity along a straight edge would drift; {@code default} only)
 * @param stiffness share of the metric a px that a weakly known direction must lose to follow at half the step, 0 to
 *     1 (ours, because the velocity along an edge hangs on its ends only; {@code default} only)
 * @param sharedScore support of the second best track plane, as a share of the best, that hides the velocity, 0 to 1
 *     (ours, because crossing objects pull at each other; {@code default} only)
 * @param foresight share of an acceleration that is taken to last from the middle of the window to now, 0 to 1 (ours,
 *     because motion that speeds up slows down again; {@code default} only)
 * @param maxBendPx shift at the end of the window by an acceleration above which the lifetime shrinks in px, 0.01 to
 *     10 (ours, because an acceleration is steady for a while only; {@code default} only)
 * @param flatChange knowledge along an edge, as a share of that across, at which its acceleration counts half, 0 to 1
 *     (ours, because along a straight edge nothing is known of acceleration; {@code default} only)
 * @param rotation whether a track plane may turn, true or false (ours, because a pendulum and a bar turn; {@code
 *     default} only)
 * @param changePx distance of the projections that measure acceleration and rotation, at the end of the window in px,
 *     0.05 to 4 (ours, because the velocity at the end of the window is wanted, not that in its middle; {@code
 *     default} only)
 * @param changeGain share of a newly measured acceleration or rotation that is taken over, 0.01 to 1 (ours, because
 *     successive windows share most events; {@code default} only)
 * @param bendPx shift at the end of the window by an acceleration or a rotation that may be noise in px, 0 to 10
 *     (ours, because most motion is steady; {@code default} only)
 * @param flatDecay share of the velocity along a straight edge that is dropped at each measurement, 0 to 1 (ours,
 *     because it would drift; {@code default} only)
 * @param maxShared share of events claimed by two track planes above which no change of motion is measured, 0 to 1
 *     (ours, because crossing objects pull at each other; {@code default} only)
 * @param maxTrackPlanes most track planes at once, 1 to 64 (ours, because memory is to be bounded)
 * @param minShare share of the expected events below which a track plane is removed, 0 to 1 (n of the paper, section
 *     Algorithm, without a number)
 * @param mergeVelocity share of the speed by which two merging track planes may differ, 0 to 1 (ours, because the
 *     paper gives no rule; {@code paper} only)
 * @param mergeLoss share of the metric that two track planes may lose by one common motion, 0 to 1 (ours, because a
 *     straight edge knows only a part of its velocity; {@code default} only)
 * @param mergeGapShare gap between boxes that may merge, as a share of the shorter of their longer sides, 0 to 4
 *     (ours, because the front and the back of an object are one segment; {@code default} only)
 */
public record SofasParameters(
    Preset preset,
    @Parameter(value = "projections of the flow plane along each of its two axes", min = 3, max = 31)
    int flowProjections,
    @Parameter(value = "speed of a projection at 45 degrees", unit = "px/s", min = 1, max = 10000)
    double velocityScalePxPerS,
    @Parameter(value = "range of the flow plane's angles", unit = "degrees", min = 1, max = 180)
    double rangeDeg,
    @Parameter(value = "factor by which a refining cycle narrows the range", min = 1.5, max = 100)
    double refinement,
    @Parameter(value = "refining cycles, the widest included", min = 1, max = 6)
    int cycles,
    @Parameter(value = "events for which the greatest metric stays with one projection", min = 1, max = 100_000)
    int constantEvents,
    @Parameter(value = "speed of the slowest ring", unit = "px/s", min = 0.1, max = 1000)
    double slowestPxPerS,
    @Parameter(value = "speed of the fastest ring", unit = "px/s", min = 1, max = 100000)
    double fastestPxPerS,
    @Parameter(value = "travel after which an event leaves a projection of the flow plane",
        unit = "px", min = 2, max = 32)
    double flowTravelPx,
    @Parameter(value = "longest time that an event stays in the flow plane",
        unit = "us", min = 1000, max = 60_000_000)
    long lifespanUs,
    @Parameter(value = "standard deviations above the mean at which a cell selects its events", min = 0, max = 10)
    double thresholdSd,
    @Parameter(value = "fewest events of a structure", min = 8, max = 100_000)
    int minEvents,
    @Parameter(value = "metric an event that a structure needs", min = 0, max = 1000)
    double evidence,
    @Parameter(value = "share of the metric within which the slowest velocity of a new structure is taken",
        min = 0, max = 1)
    double slowestWithin,
    @Parameter(value = "travel after which an event leaves a track plane", unit = "px", min = 1, max = 100)
    double lifetimePx,
    @Parameter(value = "lifetime that a steady velocity grows to", unit = "px", min = 1, max = 100)
    double maxLifetimePx,
    @Parameter(value = "longest lifetime", unit = "us", min = 1000, max = 60_000_000)
    long maxLifetimeUs,
    @Parameter(value = "correction over half the window below which a velocity is steady",
        unit = "px", min = 0, max = 4)
    double steadyPx,
    @Parameter(value = "share of its cells that a projection must hit to become the centre", min = 0.001, max = 1)
    double hitShare,
    @Parameter(value = "smallest angle between neighbouring projections", unit = "degrees", min = 0.001, max = 10)
    double minPerturbationDeg,
    @Parameter(value = "greatest angle between neighbouring projections", unit = "degrees", min = 0.01, max = 45)
    double maxPerturbationDeg,
    @Parameter(value = "missed events that make a cell contour", min = 1, max = 1000)
    int contourThreshold,
    @Parameter(value = "share of the mean support that puts an event on the contour", min = 0, max = 1)
    double contourShare,
    @Parameter(value = "travel for which a track plane remembers where its contour was",
        unit = "px", min = 0, max = 1000)
    double memoryPx,
    @Parameter(value = "longest time for which it does", unit = "us", min = 0, max = 60_000_000)
    long maxMemoryUs,
    @Parameter(value = "side of the cells that velocities are measured with", unit = "px", min = 0.5, max = 8)
    double voteCellPx,
    @Parameter(value = "events that a velocity is measured from, where they meet often", min = 32, max = 16_384)
    int sampleEvents,
    @Parameter(value = "metric an event below which a sample is enlarged", min = 0, max = 100)
    double sampleDensity,
    @Parameter(value = "share of the metric that neighbouring projections are to lose", min = 0.001, max = 1)
    double neighbourLoss,
    @Parameter(value = "smallest distance of neighbouring projections over half the window",
        unit = "px", min = 0.05, max = 4)
    double minStepPx,
    @Parameter(value = "greatest distance of neighbouring projections over half the window",
        unit = "px", min = 0.1, max = 16)
    double maxStepPx,
    @Parameter(value = "standard deviations of the metric that neighbours must lose for a direction to take a step",
        min = 0, max = 100)
    double flatSigmas,
    @Parameter(value = "share of the metric a px that a weakly known direction must lose to follow at half the step",
        min = 0, max = 1)
    double stiffness,
    @Parameter(value = "support of the second best track plane, as a share of the best, that hides the velocity",
        min = 0, max = 1)
    double sharedScore,
    @Parameter(value = "share of an acceleration that is taken to last from the middle of the window to now",
        min = 0, max = 1)
    double foresight,
    @Parameter(value = "shift at the end of the window by an acceleration above which the lifetime shrinks",
        unit = "px", min = 0.01, max = 10)
    double maxBendPx,
    @Parameter(value = "knowledge along an edge, as a share of that across, at which its acceleration counts half",
        min = 0, max = 1)
    double flatChange,
    @Parameter(value = "whether a track plane may turn")
    boolean rotation,
    @Parameter(value = "distance of the projections that measure acceleration and rotation, at the end of the window",
        unit = "px", min = 0.05, max = 4)
    double changePx,
    @Parameter(value = "share of a newly measured acceleration or rotation that is taken over", min = 0.01, max = 1)
    double changeGain,
    @Parameter(value = "shift at the end of the window by an acceleration or a rotation that may be noise",
        unit = "px", min = 0, max = 10)
    double bendPx,
    @Parameter(value = "share of the velocity along a straight edge that is dropped at each measurement",
        min = 0, max = 1)
    double flatDecay,
    @Parameter(value = "share of events claimed by two track planes above which no change of motion is measured",
        min = 0, max = 1)
    double maxShared,
    @Parameter(value = "most track planes at once", min = 1, max = 64)
    int maxTrackPlanes,
    @Parameter(value = "share of the expected events below which a track plane is removed", min = 0, max = 1)
    double minShare,
    @Parameter(value = "share of the speed by which two merging track planes may differ", min = 0, max = 1)
    double mergeVelocity,
    @Parameter(value = "share of the metric that two track planes may lose by one common motion",
        min = 0, max = 1)
    double mergeLoss,
    @Parameter(value = "gap between boxes that may merge, as a share of the shorter of their longer sides",
        min = 0, max = 4)
    double mergeGapShare) {

    /** Which method. */
    public enum Preset {
        /** As published: nearest cells, signed votes, hits. */
        PAPER,
        /** Ours: the same nouns, made accurate and fast. */
        DEFAULT
    }

    private static final RecordComponent[] COMPONENTS = SofasParameters.class.getRecordComponents();

    /**
     * Checks every component.
     *
     * @throws IllegalArgumentException where one is outside its range; the message names it
     */
    public SofasParameters {
        check(preset,
            flowProjections, velocityScalePxPerS, rangeDeg, refinement, cycles, constantEvents, slowestPxPerS,
            fastestPxPerS, flowTravelPx, lifespanUs, thresholdSd, minEvents, evidence, slowestWithin,
            lifetimePx, maxLifetimePx, maxLifetimeUs, steadyPx, hitShare, minPerturbationDeg,
            maxPerturbationDeg, contourThreshold, contourShare, memoryPx, maxMemoryUs, voteCellPx, sampleEvents,
            sampleDensity, neighbourLoss, minStepPx, maxStepPx, flatSigmas, stiffness, sharedScore, foresight,
            maxBendPx, flatChange, changePx, changeGain, bendPx, flatDecay, maxShared, maxTrackPlanes, minShare,
            mergeVelocity, mergeLoss, mergeGapShare);
        if (preset == Preset.DEFAULT) {
            requireInOrder("maxLifetimePx", maxLifetimePx, "lifetimePx", lifetimePx);
        }
        requireInOrder("maxPerturbationDeg", maxPerturbationDeg, "minPerturbationDeg", minPerturbationDeg);
        requireInOrder("maxStepPx", maxStepPx, "minStepPx", minStepPx);
        if (fastestPxPerS < 2 * slowestPxPerS) {
            throw new IllegalArgumentException("fastestPxPerS must be at least twice slowestPxPerS "
                + plain(slowestPxPerS) + " but was " + plain(fastestPxPerS));
        }
    }

    private static void requireInOrder(String greater, double value, String smaller, double bound) {
        if (value < bound) {
            throw new IllegalArgumentException(greater + " must be at least " + smaller + " " + plain(bound)
                + " but was " + plain(value));
        }
    }

    private static void check(Preset preset, Number... values) {
        if (preset == null) {
            throw new IllegalArgumentException("preset must be paper or default but was null");
        }
        int i = 0;
        for (RecordComponent component : COMPONENTS) {
            if (component.getType() == Preset.class || component.getType() == boolean.class) {
                continue;
            }
            Parameter range = component.getAnnotation(Parameter.class);
            double value = values[i++].doubleValue();
            if (!(value >= range.min() && value <= range.max())) {
                throw new IllegalArgumentException(component.getName() + " must be between " + plain(range.min())
                    + " and " + plain(range.max()) + " but was " + plain(value));
            }
        }
    }

    private static String plain(double value) {
        return value == Math.rint(value) && Math.abs(value) < 1e15 ? Long.toString((long) value)
            : Double.toString(value);
    }

    /** The method as published (Stoffregen and Kleeman, ACRA 2017); where the paper gives no number, ours. */
    public static SofasParameters paper() {
        return new SofasParameters(Preset.PAPER,
            9, 100, 180, 9, 3, 300, 4, 1500, 6, 200_000, 1, 40, 0, 0.03, 3, 3, 1_000_000, 0.15, 0.1, 0.05, 4, 3,
            0.15, 0, 0, 1.3, 2000, 1.5, 0.04, 0.5, 4, 2, 0.002, 0.5, 1, 0.25, 0.1, false, 1.5, 0.5, 0.07,
            0.05, 0.15, 64, 0.2, 0.15, 0.02, 0.8);
    }

    /** The most accurate preset, and the one to start from. */
    public static SofasParameters defaults() {
        return new SofasParameters(Preset.DEFAULT,
            9, 100, 180, 9, 3, 300, 4, 1500, 6, 1_500_000, 0.5, 40, 2.5, 0.03, 5, 16, 1_000_000, 0.15, 0.1,
            0.05, 4, 3, 0.15, 64, 2_000_000, 1.3, 1000, 1.5, 0.04, 0.5, 4, 2, 0.002, 0.5, 1, 0.25, 0.1, true,
            1.5, 0.5, 0.07, 0.05, 0.15, 64, 0.3, 0.15, 0.02, 0.8);
    }

    /** The same with another {@link #flowProjections}. */
    public SofasParameters withFlowProjections(int value) {
        return with("flowProjections", value);
    }

    /** The same with another {@link #velocityScalePxPerS}. */
    public SofasParameters withVelocityScalePxPerS(double value) {
        return with("velocityScalePxPerS", value);
    }

    /** The same with another {@link #rangeDeg}. */
    public SofasParameters withRangeDeg(double value) {
        return with("rangeDeg", value);
    }

    /** The same with another {@link #refinement}. */
    public SofasParameters withRefinement(double value) {
        return with("refinement", value);
    }

    /** The same with another {@link #cycles}. */
    public SofasParameters withCycles(int value) {
        return with("cycles", value);
    }

    /** The same with another {@link #constantEvents}. */
    public SofasParameters withConstantEvents(int value) {
        return with("constantEvents", value);
    }

    /** The same with another {@link #slowestPxPerS}. */
    public SofasParameters withSlowestPxPerS(double value) {
        return with("slowestPxPerS", value);
    }

    /** The same with another {@link #fastestPxPerS}. */
    public SofasParameters withFastestPxPerS(double value) {
        return with("fastestPxPerS", value);
    }

    /** The same with another {@link #flowTravelPx}. */
    public SofasParameters withFlowTravelPx(double value) {
        return with("flowTravelPx", value);
    }

    /** The same with another {@link #lifespanUs}. */
    public SofasParameters withLifespanUs(long value) {
        return with("lifespanUs", value);
    }

    /** The same with another {@link #thresholdSd}. */
    public SofasParameters withThresholdSd(double value) {
        return with("thresholdSd", value);
    }

    /** The same with another {@link #minEvents}. */
    public SofasParameters withMinEvents(int value) {
        return with("minEvents", value);
    }

    /** The same with another {@link #evidence}. */
    public SofasParameters withEvidence(double value) {
        return with("evidence", value);
    }

    /** The same with another {@link #slowestWithin}. */
    public SofasParameters withSlowestWithin(double value) {
        return with("slowestWithin", value);
    }

    /** The same with another {@link #lifetimePx}. */
    public SofasParameters withLifetimePx(double value) {
        return with("lifetimePx", value);
    }

    /** The same with another {@link #maxLifetimePx}. */
    public SofasParameters withMaxLifetimePx(double value) {
        return with("maxLifetimePx", value);
    }

    /** The same with another {@link #maxLifetimeUs}. */
    public SofasParameters withMaxLifetimeUs(long value) {
        return with("maxLifetimeUs", value);
    }

    /** The same with another {@link #steadyPx}. */
    public SofasParameters withSteadyPx(double value) {
        return with("steadyPx", value);
    }

    /** The same with another {@link #hitShare}. */
    public SofasParameters withHitShare(double value) {
        return with("hitShare", value);
    }

    /** The same with another {@link #minPerturbationDeg}. */
    public SofasParameters withMinPerturbationDeg(double value) {
        return with("minPerturbationDeg", value);
    }

    /** The same with another {@link #maxPerturbationDeg}. */
    public SofasParameters withMaxPerturbationDeg(double value) {
        return with("maxPerturbationDeg", value);
    }

    /** The same with another {@link #contourThreshold}. */
    public SofasParameters withContourThreshold(int value) {
        return with("contourThreshold", value);
    }

    /** The same with another {@link #contourShare}. */
    public SofasParameters withContourShare(double value) {
        return with("contourShare", value);
    }

    /** The same with another {@link #memoryPx}. */
    public SofasParameters withMemoryPx(double value) {
        return with("memoryPx", value);
    }

    /** The same with another {@link #maxMemoryUs}. */
    public SofasParameters withMaxMemoryUs(long value) {
        return with("maxMemoryUs", value);
    }

    /** The same with another {@link #voteCellPx}. */
    public SofasParameters withVoteCellPx(double value) {
        return with("voteCellPx", value);
    }

    /** The same with another {@link #sampleEvents}. */
    public SofasParameters withSampleEvents(int value) {
        return with("sampleEvents", value);
    }

    /** The same with another {@link #sampleDensity}. */
    public SofasParameters withSampleDensity(double value) {
        return with("sampleDensity", value);
    }

    /** The same with another {@link #neighbourLoss}. */
    public SofasParameters withNeighbourLoss(double value) {
        return with("neighbourLoss", value);
    }

    /** The same with another {@link #minStepPx}. */
    public SofasParameters withMinStepPx(double value) {
        return with("minStepPx", value);
    }

    /** The same with another {@link #maxStepPx}. */
    public SofasParameters withMaxStepPx(double value) {
        return with("maxStepPx", value);
    }

    /** The same with another {@link #flatSigmas}. */
    public SofasParameters withFlatSigmas(double value) {
        return with("flatSigmas", value);
    }

    /** The same with another {@link #stiffness}. */
    public SofasParameters withStiffness(double value) {
        return with("stiffness", value);
    }

    /** The same with another {@link #sharedScore}. */
    public SofasParameters withSharedScore(double value) {
        return with("sharedScore", value);
    }

    /** The same with another {@link #foresight}. */
    public SofasParameters withForesight(double value) {
        return with("foresight", value);
    }

    /** The same with another {@link #maxBendPx}. */
    public SofasParameters withMaxBendPx(double value) {
        return with("maxBendPx", value);
    }

    /** The same with another {@link #flatChange}. */
    public SofasParameters withFlatChange(double value) {
        return with("flatChange", value);
    }

    /** The same with another {@link #rotation}. */
    public SofasParameters withRotation(boolean value) {
        return with("rotation", value);
    }

    /** The same with another {@link #changePx}. */
    public SofasParameters withChangePx(double value) {
        return with("changePx", value);
    }

    /** The same with another {@link #changeGain}. */
    public SofasParameters withChangeGain(double value) {
        return with("changeGain", value);
    }

    /** The same with another {@link #bendPx}. */
    public SofasParameters withBendPx(double value) {
        return with("bendPx", value);
    }

    /** The same with another {@link #flatDecay}. */
    public SofasParameters withFlatDecay(double value) {
        return with("flatDecay", value);
    }

    /** The same with another {@link #maxShared}. */
    public SofasParameters withMaxShared(double value) {
        return with("maxShared", value);
    }

    /** The same with another {@link #maxTrackPlanes}. */
    public SofasParameters withMaxTrackPlanes(int value) {
        return with("maxTrackPlanes", value);
    }

    /** The same with another {@link #minShare}. */
    public SofasParameters withMinShare(double value) {
        return with("minShare", value);
    }

    /** The same with another {@link #mergeVelocity}. */
    public SofasParameters withMergeVelocity(double value) {
        return with("mergeVelocity", value);
    }

    /** The same with another {@link #mergeLoss}. */
    public SofasParameters withMergeLoss(double value) {
        return with("mergeLoss", value);
    }

    /** The same with another {@link #mergeGapShare}. */
    public SofasParameters withMergeGapShare(double value) {
        return with("mergeGapShare", value);
    }

    private SofasParameters with(String name, Object value) {
        RecordComponent[] components = getClass().getRecordComponents();
        Object[] values = new Object[components.length];
        Class<?>[] types = new Class<?>[components.length];
        try {
            for (int i = 0; i < components.length; i++) {
                types[i] = components[i].getType();
                values[i] = components[i].getName().equals(name) ? value : components[i].getAccessor().invoke(this);
            }
            return SofasParameters.class.getDeclaredConstructor(types).newInstance(values);
        } catch (InvocationTargetException e) {
            throw (IllegalArgumentException) e.getCause();
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException(e);
        }
    }
}
