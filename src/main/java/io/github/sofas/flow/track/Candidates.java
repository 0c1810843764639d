package io.github.sofas.flow.track;

import java.util.Arrays;

/**
 * The track planes that expect an event, and whose it is: that of the nearest contour, unless the edge came farther
 * along the motion of another.
 *
 * <p>Ours. A contour has what its plane was given before, so that of structures that overlap the one that has been
 * given more gets more; {@link PixelHistory} knows the events of late whatever they were taken for. Edges that come as
 * far along several motions, as those of the pieces that a body is found in, stay with their piece.
 */
final class Candidates {
    /** Close support decides which contour is nearest, and support by all cells around it where that is the same. */
    private static final int CLOSE_WEIGHT = 4 * ContourCells.SIXTEENTHS;
    /** Score of the second contour, as a share of the nearest, that hides the velocity: crossing objects pull. */
    private static final double SHARED_SCORE = 0.5;
    /** Support below this many thresholds is weak. */
    private static final int WEAK = 2;

    private TrackPlane[] planes = new TrackPlane[16];
    private int size;
    private TrackPlane nearest;
    /** Scores of the nearest contour and of the second. */
    private int most;
    private int second;
    // of the plane that has the event
    private TrackPlane best;
    private int support;
    private int closeSupport;

    /** Begins with an event. */
    void clear() {
        size = 0;
        best = null;
        nearest = null;
        most = Integer.MIN_VALUE;
        second = Integer.MIN_VALUE;
    }

    /** Considers a plane, which is a candidate if the event lies on its contour. */
    void offer(TrackPlane plane, int x, int y, long timeUs, int polarity) {
        int its = plane.support(x, y, timeUs, polarity);
        if (its < plane.threshold()) {
            return;
        }
        if (size == planes.length) {
            planes = Arrays.copyOf(planes, 2 * size);
        }
        planes[size++] = plane;
        int close = plane.closeSupport(polarity);
        int score = close * CLOSE_WEIGHT + its;
        if (score > most) {
            second = most;
            most = score;
            nearest = plane;
            support = its;
            closeSupport = close;
        } else if (score > second) {
            second = score;
        }
    }

    /** The plane that the event belongs to; null where there is no candidate. */
    TrackPlane best(PixelHistory history, int x, int y, long timeUs, int polarity) {
        best = nearest;
        if (size > 1) {
            int farthest = history.trace(x, y, timeUs, polarity, nearest.motion()) + PixelHistory.ON_THE_PIXEL;
            for (int i = 0; i < size; i++) {
                int trace = planes[i] == nearest ? 0
                    : history.traceBeyond(farthest, x, y, timeUs, polarity, planes[i].motion());
                if (trace > farthest) {
                    farthest = trace;
                    best = planes[i];
                }
            }
            if (best != nearest) {
                support = best.support(x, y, timeUs, polarity);
                closeSupport = best.closeSupport(polarity);
            }
        }
        return best;
    }

    /** Whether it is doubtful that the event is of the plane that has it. */
    boolean isDoubtful() {
        return closeSupport < best.sureSupport();
    }

    /** Whether two contours are about as near, so that the event should measure neither motion. */
    boolean areClose() {
        return second > SHARED_SCORE * most;
    }

    /** Whether the support by the contour of the plane that has the event is weak. */
    boolean isWeak() {
        return support < WEAK * best.threshold();
    }
}
