package io.github.sofas.flow.smooth;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.motion.Motion;
import io.github.sofas.flow.motion.PixelBox;
import io.github.sofas.flow.motion.SteppedProjection;
import java.util.List;

/**
 * Recognises lost segments: a structure that turns round or pauses is lost where it stands, and the engine finds it
 * again as another segment with another velocity. The two are the same on three conditions. The lost one has had few
 * events since, the other began about where the motion of the lost one leads, and their contours agree when laid on one
 * another.
 */
final class KnownAgain {
    /** Travel over which a contour is drawn, in px. */
    private static final double DRAWN_PX = 8;
    /** Fewest events of a contour. */
    private static final int LEAST = 30;
    /** Share of the events of either contour that must lie within a px of the other contour. */
    private static final double LEAST_AGREEMENT = 0.65;
    /** Events of a segment in a slice, as a share of its most in any slice so far, above which it is not lost yet. */
    private static final double STRONG = 1.0 / 3;
    /** Events that a lost segment may still get, as a share of those of the segment that began. */
    private static final double LEFT = 0.5;
    /** Slowest motion that contours are drawn along, in px/s. */
    private static final double SLOWEST_PX_PER_S = 1;
    /**
     * Distance in px from the expected place within which a segment may begin, besides the way it may have gone in
     * between.
     */
    private static final double ROOM_PX = 3;
    /** Part of a px that one step of the projection may take. */
    private static final double STEP_PX = 0.25;

    private final EventWindow window;
    private final SegmentCursor cursor;
    private final Picture lostPicture;
    private final Picture begunPicture;
    private final SteppedProjection projection = new SteppedProjection();
    private final Motion along = new Motion();
    private final Motion last = new Motion();
    private final Motion first = new Motion();
    /** Time until which the lost segment was seen well. */
    private long seenUs;

    KnownAgain(SensorSize sensor, EventWindow window) {
        this.window = window;
        cursor = new SegmentCursor(window);
        lostPicture = new Picture(sensor);
        begunPicture = new Picture(sensor);
    }

    /**
     * Finds the lost segment that a segment continues.
     *
     * @param slices slices with the last events of the segments, in order
     * @return the path of the lost segment; null where there is none
     */
    SegmentPath find(SegmentPath begun, Iterable<SegmentPath> paths, List<Slice> slices) {
        boolean isDrawn = false;
        double mayBeLeft = 0;
        SegmentPath best = null;
        double greatest = LEAST_AGREEMENT;
        for (SegmentPath lost : paths) {
            if (!wasSeenBefore(lost, begun, slices)) {
                continue;
            }
            if (!isDrawn) {
                begun.at(begun.firstSeenUs(), first);
                draw(begun, first, 1, slices, begunPicture);
                if (begunPicture.events() < LEAST) {
                    return null;
                }
                mayBeLeft = LEFT * events(begun, begun.firstSeenUs(), slices);
                isDrawn = true;
            }
            if (events(lost, begun.firstSeenUs(), slices) > mayBeLeft) {
                continue;
            }
            lost.at(seenUs, last);
            draw(lost, last, -1, slices, lostPicture);
            double agreement = lostPicture.events() < LEAST || !leadsTo(begun) ? 0
                : lostPicture.agreement(begunPicture);
            if (agreement > greatest) {
                greatest = agreement;
                best = lost;
            }
        }
        return best;
    }

    /**
     * Whether another segment has a contour from before this one began; notes until when that contour was seen well.
     */
    private boolean wasSeenBefore(SegmentPath lost, SegmentPath begun, List<Slice> slices) {
        if (lost == begun || !lost.isMeasured() || lost.hasEnded()
                || lost.first().referenceUs >= begun.first().referenceUs) {
            return false;
        }
        int most = 0;
        for (Slice slice : slices) {
            PixelBox box = slice.box(lost.id());
            if (slice.fromUs < begun.firstSeenUs() && box != null) {
                most = Math.max(most, box.events);
                if (box.events > STRONG * most) {
                    seenUs = Math.min(slice.untilUs, begun.firstSeenUs());
                }
            }
        }
        return most >= LEAST;
    }

    /** Number of events of a segment from a time on. */
    private int events(SegmentPath path, long fromUs, List<Slice> slices) {
        int events = 0;
        cursor.begin(slices, path.id(), fromUs, Long.MAX_VALUE);
        while (cursor.next() != SegmentCursor.NONE) {
            events++;
        }
        return events;
    }

    /**
     * Whether the lost segment was, or would be, about where the other began, however its motion changed in between.
     */
    private boolean leadsTo(SegmentPath begun) {
        double gap = (begun.firstSeenUs() - seenUs) * 1e-6;
        double x = begunPicture.middleX() - lostPicture.middleX() - 0.5 * gap * (last.vx + first.vx);
        double y = begunPicture.middleY() - lostPicture.middleY() - 0.5 * gap * (last.vy + first.vy);
        double way = 0.5 * gap * (Math.hypot(last.vx, last.vy) + Math.hypot(first.vx, first.vy));
        double thickness = Math.max(lostPicture.thickness(), begunPicture.thickness());
        return Math.hypot(x, y) < way + thickness / 2 + ROOM_PX;
    }

    /** Draws the events of a segment after a time, or before it, moved to that time. */
    private void draw(SegmentPath path, Motion at, int side, List<Slice> slices, Picture picture) {
        picture.clear();
        long us = at.referenceUs;
        long sideUs = (long) (DRAWN_PX / Math.max(at.speed(0), SLOWEST_PX_PER_S) * 1e6);
        path.at(us + side * sideUs / 2, along);
        along.moveReference(us);
        projection.begin(along, sideUs, 1, STEP_PX);
        cursor.begin(slices, path.id(), side > 0 ? us : us - sideUs + 1, side > 0 ? us + sideUs : us + 1);
        for (int k = cursor.next(); k != SegmentCursor.NONE; k = cursor.next()) {
            projection.advance(window.timeUs[k]);
            picture.add(projection.x(window.x[k], window.y[k]), projection.y(window.x[k], window.y[k]));
        }
    }
}
