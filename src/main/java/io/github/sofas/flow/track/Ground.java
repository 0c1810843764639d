package io.github.sofas.flow.track;

/**
 * The wide texture that an event is offered to, as that of a wall, and whose an event is of this and of what moves
 * before it.
 *
 * <p>Ours, because a single event does not tell. In a dense texture, edges come along any motion by chance. And what
 * comes out from behind a body lies on no contour of the wall yet, but on the body's, once that has got some of it: so
 * each body drew a tail of the wall along. But over the events of a place of the body, edges come farther along the
 * body's motion than along the wall's, and over those of a place of the tail they do not ({@link ContourMemory#lead}).
 */
final class Ground {
    /** Lead that gives a body or the wall what both contours expect, whatever the event's own trace. */
    private static final double CLEAR_LEAD = PixelHistory.ON_THE_PIXEL;
    /** Of a place that is the body's so clearly, one event in so many is traced: most of a body's places are. */
    private static final int CLEAR_STRIDE = 4;

    private TrackPlane plane;

    /** Begins with an event. */
    void clear() {
        plane = null;
    }

    /** Considers a plane in whose box the event lies. */
    void offer(TrackPlane its) {
        if (its.contour().isWide() && (plane == null || its.contour().extent() > plane.contour().extent())) {
            plane = its;
        }
    }

    /** The plane of the texture; null for none. */
    TrackPlane plane() {
        return plane;
    }

    /** Whether it is behind a body, and has an event that the body's contour or memory has. */
    boolean has(TrackPlane body, TracedEvent event) {
        if (!isBehind(body)) {
            return false;
        }
        double lead = lead(body, event);
        return event.support(plane) >= plane.threshold() ? lead < -CLEAR_LEAD
            : lead < 0 && plane.contour().goesOnFrom(event.x, event.y, event.timeUs);
    }

    /** Whether it is behind a body, and leaves that an event on both contours. */
    boolean yields(TrackPlane body, TracedEvent event) {
        return isBehind(body) && lead(body, event) > CLEAR_LEAD;
    }

    /** Whether it lies behind the structure of a plane, as far as its size tells. */
    private boolean isBehind(TrackPlane body) {
        return plane != null && plane != body && plane.contour().breadth() >= body.contour().radius();
    }

    private double lead(TrackPlane body, TracedEvent event) {
        double lead = body.memory().lead(event.x, event.y, event.timeUs);
        int stride = lead > CLEAR_LEAD ? CLEAR_STRIDE : 1;
        return event.isOneIn(stride) ? body.memory().takeLead(event.trace(body) - event.trace(plane), stride) : lead;
    }
}
