package io.github.sofas.flow;

import io.github.sofas.event.SensorSize;

/**
 * The most memory that an engine holds, by the formula told at {@link Sofas#mostBytes}. Nothing but the arrays counted
 * here grows with the events; what a track plane needs is used again by later ones.
 */
final class MemoryBound {
    /** Objects, headers of arrays, arrays by projection and by block. */
    private static final long FIXED_BYTES = 1 << 20;
    /** Of the default preset's rings. */
    private static final long EVENTS = 1 << 20;
    private static final int RING_BYTES = Long.BYTES + 2 * Short.BYTES + Byte.BYTES + 2 * Integer.BYTES;
    /** Three arrays of numbers, as long as they may have grown. */
    private static final int SORTING_BYTES = 3 * 2 * Integer.BYTES;
    private static final int LIVE_EVENT_BYTES = Long.BYTES + 2 * Short.BYTES + 3 * Byte.BYTES + Integer.BYTES;
    private static final int FITTED_EVENT_BYTES = 12 * Integer.BYTES + Byte.BYTES;
    /** Of the paper preset's arrays of events; a doubling beyond what fills half of them. */
    private static final long PAPER_EVENTS = 2 * (PaperFlowPlane.MOST_EVENTS + 1);

    private MemoryBound() {
    }

    static long bytes(SensorSize sensor, SofasParameters p) {
        return FIXED_BYTES + (p.preset() == SofasParameters.Preset.PAPER ? paper(sensor, p) : refined(sensor, p));
    }

    private static long refined(SensorSize sensor, SofasParameters p) {
        long pixels = (long) sensor.width() * sensor.height();
        long cells = 1L << FlowPlane.bits(sensor.width(), p) + FlowPlane.bits(sensor.height(), p);
        long projections = (long) p.flowProjections() * p.flowProjections();
        // pieces are found with two marks a cell and up to two counts
        long search = cells * (projections * Short.BYTES + 4 * Integer.BYTES)
            + EVENTS * (RING_BYTES + SORTING_BYTES);
        long company = Integer.BYTES * (pixels + (sensor.width() + 2L) * (sensor.height() + 2L));
        long fit = Integer.BYTES * VoteGrid.cells(sensor.width(), sensor.height(), p.voteCellPx())
            + LiveEvents.CAPACITY * FITTED_EVENT_BYTES + Registration.bytes(sensor.width(), sensor.height())
            + StrayEvents.CAPACITY * (Long.BYTES + 2L * Short.BYTES);
        long plane = Integer.BYTES * (sensor.width() + 2L * Contour.MARGIN) * (sensor.height() + 2L * Contour.MARGIN)
            + ((long) Integer.BYTES << Shape.bits(sensor.width()) + Shape.bits(sensor.height()))
            + LiveEvents.CAPACITY * LIVE_EVENT_BYTES + PlaceTrack.bytes();
        // one more ring, for merging
        return search + company + 2 * fit + p.maxTrackPlanes() * plane + LiveEvents.CAPACITY * LIVE_EVENT_BYTES;
    }

    private static long paper(SensorSize sensor, SofasParameters p) {
        long columns = 0;
        long rows = 0;
        for (int i = 0; i < p.flowProjections(); i++) {
            int velocity = PaperFlowPlane.velocity(i, p);
            columns += PaperFlowPlane.side(sensor.width(), velocity, p);
            rows += PaperFlowPlane.side(sensor.height(), velocity, p);
        }
        double farthest = p.velocityAt(PaperRefinement.STEEPEST_DEG) * p.lifespanUs() * 1e-6;
        long refined = (long) (Math.min(PaperFlowPlane.LONGEST_SIDE, sensor.width() + farthest + 1) + 2)
            * (long) (Math.min(PaperFlowPlane.LONGEST_SIDE, sensor.height() + farthest + 1) + 2);
        long search = columns * rows * Short.BYTES + refined * (2 * Integer.BYTES + 1)
            + PAPER_EVENTS * (Long.BYTES + 2 * Short.BYTES + 2 * Byte.BYTES + Integer.BYTES)
            + 2L * p.flowProjections() * PaperVotes.BLOCK * Integer.BYTES;
        long cells = (long) PaperTrackPlane.side(sensor.width(), p) * PaperTrackPlane.side(sensor.height(), p);
        // nine accumulators, raised counts, their folds, and the list of raised cells, as long as it may have grown
        long plane = cells * (10 * Short.BYTES + 3 * Integer.BYTES)
            + PAPER_EVENTS * (Long.BYTES + (2 + 2 * PaperTrackPlane.SIDE) * Short.BYTES);
        return search + p.maxTrackPlanes() * plane;
    }
}
