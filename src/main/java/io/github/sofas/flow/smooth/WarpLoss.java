package io.github.sofas.flow.smooth;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.motion.Motion;
import io.github.sofas.flow.motion.PixelBox;
import java.util.List;

/**
 * Takes the labels away from events that the path of their segment would blur: moved along it, they meet less often
 * than where they are. The measure is flow warp loss, which assesses flow without a ground truth (Stoffregen et al.
 * 2020), applied segment by segment. Ours, because a path runs on where its segment stops or reverses, and the engine,
 * which knows the past only, misses that.
 */
final class WarpLoss {
    /** Travel on either side of a time over which events are moved to that time, in px. */
    private static final double SIDE_PX = 8;
    /** Travel over both sides, in px, below which it does not show which picture is sharper. */
    private static final double LEAST_TRAVEL_PX = 2;
    /** Fewest events that show anything. */
    private static final int LEAST_EVENTS = 30;
    /**
     * Meetings along the path, as a multiple of those at rest, above which the path is beyond doubt for half of the
     * travel.
     */
    private static final double SURE = 1.05;
    /** Steps of the projection over both sides. */
    private static final int STEPS = 128;

    private final EventWindow window;
    private final SegmentCursor cursor;
    private final WarpedPicture picture;
    private final PathProjection projection = new PathProjection();
    private final Motion motion = new Motion();

    WarpLoss(SensorSize sensor, EventWindow window) {
        this.window = window;
        cursor = new SegmentCursor(window);
        picture = new WarpedPicture(sensor);
    }

    /** Bytes of its arrays. */
    static long bytes(SensorSize sensor) {
        return WarpedPicture.bytes(sensor);
    }

    /**
     * Takes labels away from events of a segment in a slice.
     *
     * @param slices the slices around it, in order
     * @param mostSideUs most time that is looked at on either side
     */
    void unlabel(SegmentPath path, List<Slice> slices, Slice slice, long mostSideUs) {
        SegmentEvents own = slice.bySegment(window);
        int from = own.from(path.id());
        int until = own.until(path.id());
        path.at(slice.middleUs(), motion);
        double speed = Math.max(motion.speed(radius(own, from, until)), 1e-3);
        long sideUs = (long) Math.min(SIDE_PX / speed * 1e6, mostSideUs);
        if (2e-6 * sideUs * speed < LEAST_TRAVEL_PX) {
            return;
        }
        long blockUs = Math.min(2 * sideUs, slice.untilUs - slice.fromUs);
        int end = from;
        for (long us = slice.fromUs; us < slice.untilUs; us += blockUs) {
            int begin = end;
            while (end < until && window.timeUs[window.at(own.event(end))] < us + blockUs) {
                end++;
            }
            if (end > begin && blurs(path, slices, us + blockUs / 2, sideUs)) {
                for (int k = begin; k < end; k++) {
                    window.give(window.at(own.event(k)), 0, 0);
                }
            }
        }
    }

    /** Approximate root mean square distance of events from their middle. */
    private double radius(SegmentEvents own, int from, int until) {
        PixelBox box = new PixelBox();
        for (int k = from; k < until; k++) {
            int at = window.at(own.event(k));
            box.add(window.x[at], window.y[at]);
        }
        return box.radius();
    }

    private boolean blurs(SegmentPath path, List<Slice> slices, long us, long sideUs) {
        if (us < path.sureUntilUs()) {
            return false;
        }
        projection.begin(path, us, us - sideUs, STEPS / (2.0 * sideUs), STEPS);
        if (draw(path, slices, us - sideUs, us + sideUs, true) < LEAST_EVENTS) {
            return false;
        }
        double along = picture.meetings();
        draw(path, slices, us - sideUs, us + sideUs, false);
        double atRest = picture.meetings();
        if (along > SURE * atRest) {
            path.beSure(us + sideUs);
        }
        return along < atRest;
    }

    /**
     * Draws the events of a segment from one time to before another, along its path or where they are; returns their
     * number.
     */
    private int draw(SegmentPath path, List<Slice> slices, long fromUs, long untilUs, boolean isMoved) {
        picture.clear();
        int events = 0;
        cursor.begin(slices, path.id(), fromUs, untilUs);
        for (int k = cursor.next(); k != SegmentCursor.NONE; k = cursor.next()) {
            events++;
            if (isMoved) {
                projection.goTo(projection.step(window.timeUs[k] - fromUs));
                picture.add(projection.x(window.x[k], window.y[k]), projection.y(window.x[k], window.y[k]));
            } else {
                picture.add(window.x[k], window.y[k]);
            }
        }
        return events;
    }
}
