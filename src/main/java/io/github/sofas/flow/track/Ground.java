package io.github.sofas.flow.track;

/**
 * Finds the ground of an event, a wide texture such as a wall, and decides whether the event belongs to the ground or
 * to a body that moves in front of it.
 *
 * <p>Ours, because a single event does not show this. In a dense texture, edges come along any motion by chance. A part
 * of the wall that comes out from behind a body is not on the contour of the wall yet. It is on that of the body, once
 * the body has taken some of its events. Each body therefore drew a tail of the wall along. The mean over the events of
 * a place decides ({@link ContourMemory#lead}): on the body, edges come farther along the body's motion than along the
 * wall's; on the tail they do not.
 */
final class Ground {
    /** Lead that decides between a body and the wall where both contours expect an event, whatever its own trace. */
    private static final double CLEAR_LEAD = PixelHistory.ON_THE_PIXEL;
    /** Where the lead of a body is clear, as at most of its places, only one event in this many is traced. */
    private static final int CLEAR_STRIDE = 4;

    private TrackPlane plane;

    /** Starts with a new event. */
    void clear() {
        plane = null;
    }

    /** Considers a plane whose box holds the event. */
    void offer(TrackPlane its) {
        if (its.contour().isWide() && (plane == null || its.contour().extent() > plane.contour().extent())) {
            plane = its;
        }
    }

    /** Returns the plane of the ground; null for none. */
    TrackPlane plane() {
        return plane;
    }

    /** Whether the ground is behind a body, and gets an event that the body's contour or memory claims. */
    boolean has(TrackPlane body, TracedEvent event) {
        if (!isBehind(body)) {
            return false;
        }
        double lead = lead(body, event);
        return event.support(plane) >= plane.threshold() ? lead < -CLEAR_LEAD
            : lead < 0 && plane.contour().goesOnFrom(event.x, event.y, event.timeUs);
    }

    /** Whether the ground is behind a body, and leaves an event on both contours to the body. */
    boolean yields(TrackPlane body, TracedEvent event) {
        return isBehind(body) && lead(body, event) > CLEAR_LEAD;
    }

    /** Whether the ground lies behind the structure of a plane, judged by size. */
    private boolean isBehind(TrackPlane body) {
        return plane != null && plane != body && plane.contour().breadth() >= body.contour().radius();
    }

    private double lead(TrackPlane body, TracedEvent event) {
        double lead = body.memory().lead(event.x, event.y, event.timeUs);
        int stride = lead > CLEAR_LEAD ? CLEAR_STRIDE : 1;
        return event.isOneIn(stride) ? body.memory().takeLead(event.trace(body) - event.trace(plane), stride) : lead;
    }
}
