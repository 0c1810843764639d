package io.github.sofas.flow;

/**
 * Every parameter of the method.
 *
 * @param projections rings of speed, and directions a ring, of the flow plane
 * @param slowestPxPerS speed of the slowest ring
 * @param fastestPxPerS speed of the fastest ring
 * @param flowTravelPx travel after which an event leaves a projection of the flow plane
 * @param lifespanUs longest time that an event stays in the flow plane
 * @param evidence metric an event that a structure needs
 * @param minEvents fewest events of a structure
 * @param thresholdSd standard deviations above the mean at which a cell selects its events
 * @param lifetimePx travel after which an event leaves a track plane whose velocity changes
 * @param maxLifetimePx travel after which an event leaves a track plane whose velocity is steady
 * @param maxLifetimeUs longest time that an event stays in a track plane
 * @param contourShare share of the mean support that puts an event on the contour
 * @param sampleEvents most events that a velocity is measured from
 * @param flatShare curvature of the metric below which a direction takes no step
 * @param minStepPx smallest distance of neighbouring projections over half the window
 * @param steadyPx correction over half the window below which a velocity is steady
 * @param maxTrackPlanes most track planes at once
 * @param mergeLoss share of the metric that two track planes may lose by one common velocity
 * @param minShare share of its usual events below which a track plane is removed
 */
public record SofasParameters(
    @Parameter(value = "rings of speed, and directions a ring, of the flow plane", min = 3, max = 31)
    int projections,
    @Parameter(value = "speed of the slowest ring", unit = "px/s", min = 0.1, max = 1000)
    double slowestPxPerS,
    @Parameter(value = "speed of the fastest ring", unit = "px/s", min = 1, max = 100_000)
    double fastestPxPerS,
    @Parameter(value = "travel after which an event leaves a projection", unit = "px", min = 2, max = 32)
    double flowTravelPx,
    @Parameter(value = "longest time in the flow plane", unit = "us", min = 1000, max = 60_000_000)
    long lifespanUs,
    @Parameter(value = "metric an event that a structure needs", min = 0, max = 1000)
    double evidence,
    @Parameter(value = "fewest events of a structure", min = 8, max = 100_000)
    int minEvents,
    @Parameter(value = "standard deviations above the mean at which a cell selects its events", max = 10)
    double thresholdSd,
    @Parameter(value = "lifetime of a changing velocity", unit = "px", min = 1, max = 100)
    double lifetimePx,
    @Parameter(value = "lifetime of a steady velocity", unit = "px", min = 1, max = 100)
    double maxLifetimePx,
    @Parameter(value = "longest lifetime", unit = "us", min = 1000, max = 60_000_000)
    long maxLifetimeUs,
    @Parameter("share of the mean support that puts an event on the contour")
    double contourShare,
    @Parameter(value = "most events that a velocity is measured from", min = 32, max = 100_000)
    int sampleEvents,
    @Parameter("curvature of the metric below which a direction takes no step")
    double flatShare,
    @Parameter(value = "smallest distance of projections over half the window", unit = "px", min = 0.05, max = 4)
    double minStepPx,
    @Parameter(value = "correction below which a velocity is steady", unit = "px", max = 4)
    double steadyPx,
    @Parameter(value = "most track planes at once", min = 1, max = 64)
    int maxTrackPlanes,
    @Parameter("share of the metric that two track planes may lose by one velocity")
    double mergeLoss,
    @Parameter("share of its usual events below which a track plane is removed")
    double minShare) {

    /** The most accurate preset. */
    public static SofasParameters defaults() {
        return new SofasParameters(15, 4, 1500, 6, 1_500_000, 3, 40, 0.5, 6, 16, 1_000_000, 0.15, 1000, 0.002, 0.5,
            0.15, 64, 0.03, 0.2);
    }
}
