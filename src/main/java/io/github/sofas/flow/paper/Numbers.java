package io.github.sofas.flow.paper;

import io.github.sofas.flow.SofasParameters;

/**
 * The numbers of the published method: the parameters that it uses, and the constants that are the same for all
 * recordings. {@link #of} puts both together.
 *
 * @param flowProjections n of the flow plane, which has n x n projections
 * @param lifespanUs longest time for which an event stays in the flow plane
 * @param thresholdSd w of the flow plane: standard deviations above the mean at which a cell selects its events
 * @param minEvents least number of events of a structure
 * @param constantEvents p of the flow plane: number of events for which one projection must keep the greatest metric
 * @param velocityScalePxPerS speed of a projection at 45 degrees
 * @param rangeDeg r of the flow plane: range of its angles
 * @param refinement q of the flow plane: factor by which a refining cycle narrows the range
 * @param cycles number of refining cycles, including the one with the widest range
 * @param lifetimePx p of the track plane: travel after which an event leaves it
 * @param maxLifetimeUs longest lifetime: a structure that stands still would otherwise keep its events for ever
 * @param hitShare share of its occupied cells that the hits of a projection must pass for it to become the centre
 * @param minPerturbationDeg smallest angle between neighbouring projections: halving without end stops all tracking
 * @param maxPerturbationDeg greatest angle between neighbouring projections
 * @param contourThreshold number of events that miss the contour on a cell, beyond which the cell becomes contour
 * @param maxTrackPlanes greatest number of track planes at once
 * @param minShare share of the expected events below which a track plane is removed
 * @param mergeVelocity share of the speed by which the velocities of two merging track planes may differ
 */
public record Numbers(int flowProjections, long lifespanUs, double thresholdSd, int minEvents, int constantEvents,
                      double velocityScalePxPerS, double rangeDeg, double refinement, int cycles, double lifetimePx,
                      long maxLifetimeUs, double hitShare, double minPerturbationDeg, double maxPerturbationDeg,
                      int contourThreshold, int maxTrackPlanes, double minShare, double mergeVelocity) {
    /** The paper, section Flow Plane: 180, 20, 2.2 degrees. */
    private static final double RANGE_DEG = 180;
    private static final double REFINEMENT = 9;
    private static final int CYCLES = 3;
    /** The paper, section Track Plane: 10 %. */
    private static final double HIT_SHARE = 0.1;
    // ours, where the paper gives none
    private static final long MAX_LIFETIME_US = 1_000_000;
    private static final double MIN_PERTURBATION_DEG = 0.05;
    private static final double MAX_PERTURBATION_DEG = 4;
    private static final int CONTOUR_THRESHOLD = 3;
    private static final double MERGE_VELOCITY = 0.15;

    /** Returns the numbers for some parameters. */
    public static Numbers of(SofasParameters p) {
        return new Numbers(p.search().flowProjections(), p.search().lifespanUs(), p.search().thresholdSd(),
            p.search().minEvents(), p.published().constantEvents(), p.published().velocityScalePxPerS(), RANGE_DEG,
            REFINEMENT, CYCLES, p.track().lifetimePx(), MAX_LIFETIME_US, HIT_SHARE, MIN_PERTURBATION_DEG,
            MAX_PERTURBATION_DEG, CONTOUR_THRESHOLD, p.track().maxTrackPlanes(), p.track().minShare(), MERGE_VELOCITY);
    }
}
