package io.github.sofas.flow.smooth;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.fit.MeetingPicture;
import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.motion.Motion;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Bends a path until the events of each short part of the time lie where those of the other parts do. Along the true
 * path, all parts make one picture; what a part lies beside it is the error of the path. Ours, because a motion that is
 * measured over some px of travel bends evenly. The motion of a structure that reverses, stops or sets off does not,
 * but its picture stays the same. Polarities are ignored, because they change as a structure reverses.
 */
final class PathAlignment {
    /** Slices that are looked at on either side of the slice whose path is bent, and parts per slice. */
    private static final int SIDE_SLICES = 2;
    private static final int PARTS_OF_SLICE = 4;
    private static final int PARTS = (2 * SIDE_SLICES + 1) * PARTS_OF_SLICE;
    /**
     * Shortest slice. With look-aheads of less than 100 ms, the time looked at is too short for parts with pictures of
     * their own, and real recordings become less sharp.
     */
    private static final long LEAST_SLICE_US = 25_000;
    /** Shift, in px, by the bend of a path on either side, below which the path is steady. */
    private static final double STEADY_PX = 0.1;
    /** Steps of the projection. */
    private static final int STEPS = 128;
    /** Events that are wanted where there are more, and room for them: the chosen squares may have more than others. */
    private static final int WANTED_EVENTS = 14_000;
    private static final int MOST_EVENTS = 1 << 14;
    private static final int LEAST_EVENTS = 60;
    private static final int ROUNDS = 8;
    /**
     * Least gain of the metric, in standard deviations; the share of it that the first round must promise; and the same
     * for each round after it, without which the parts are where they belong.
     */
    private static final double LEAST_SIGMAS = 1;
    private static final double FIRST_SHARE = 0.3;
    private static final double NEXT_SHARE = 0.02;
    /** Shift, in px, that at least one part must reach. */
    private static final double LEAST_PX = 0.15;

    private final EventWindow window;
    private final SegmentCursor cursor;
    private final PathProjection projection = new PathProjection();
    private final MeetingPicture picture;
    private final PartShifts shifts = new PartShifts(PARTS);
    private final PathLength length;
    // places of the events at the reference time, and their pixels with polarity
    private final int[] x = new int[MOST_EVENTS];
    private final int[] y = new int[MOST_EVENTS];
    private final int[] pixel = new int[MOST_EVENTS];
    /** Index of the first event of each part. */
    private final int[] start = new int[PARTS + 1];
    private final long[] sums = new long[MeetingPicture.BESIDE * MeetingPicture.BESIDE];
    private final double[] met = new double[sums.length];
    private final Motion middle = new Motion();
    private final Motion side = new Motion();
    private long fromUs;
    private long untilUs;

    PathAlignment(SensorSize sensor, EventWindow window) {
        this.window = window;
        cursor = new SegmentCursor(window);
        picture = new MeetingPicture(sensor);
        length = new PathLength(sensor, MOST_EVENTS, picture);
    }

    /** Bytes of its arrays. */
    static long bytes(SensorSize sensor) {
        return MeetingPicture.bytes(sensor) + PathLength.bytes(sensor, MOST_EVENTS) + 3L * Integer.BYTES * MOST_EVENTS;
    }

    /**
     * Bends a path in a slice, if its events meet more often along the bent path; does nothing if slices are short.
     *
     * @param slices the slices around it, in order
     * @param sliceUs duration of a slice in µs
     */
    void bend(SegmentPath path, List<Slice> slices, Slice slice, long sliceUs) {
        fromUs = Math.max(slice.fromUs - SIDE_SLICES * sliceUs, Math.min(path.firstSeenUs(), slice.fromUs));
        untilUs = slice.untilUs + SIDE_SLICES * sliceUs;
        if (sliceUs < LEAST_SLICE_US || isKept(path, slice.middleUs())) {
            return;
        }
        projection.begin(path, slice.middleUs(), fromUs, (double) STEPS / (untilUs - fromUs), STEPS);
        if (place(path.id(), slices) >= LEAST_EVENTS && align()) {
            moveByShifts();
            path.replace(slice.fromUs, slice.untilUs, knots(path, slice, length.factor(pixel, x, y, start[PARTS])));
        }
    }

    /**
     * Whether the path is kept as it is. A straight path is right as measured; where the picture is deformed, no part
     * has the picture of another.
     */
    private boolean isKept(SegmentPath path, long middleUs) {
        path.at(middleUs, middle);
        return !middle.deformation.isNone()
            || bendPx(path, fromUs) < STEADY_PX && bendPx(path, untilUs) < STEADY_PX;
    }

    /** Shift, in px, by the change of the velocity between the middle and a time. */
    private double bendPx(SegmentPath path, long us) {
        path.at(us, middle, side);
        return Math.hypot(side.vx - middle.vx, side.vy - middle.vy) * Math.abs(us - middle.referenceUs) * 0.5e-6;
    }

    /** Moves the segment's events to the reference time; returns how many there are. */
    private int place(int segment, List<Slice> slices) {
        long share = Squares.share(count(segment, slices), WANTED_EVENTS);
        int n = 0;
        int part = 0;
        cursor.begin(slices, segment, fromUs, untilUs);
        for (int k = cursor.next(); k != SegmentCursor.NONE && n < MOST_EVENTS; k = cursor.next()) {
            long us = window.timeUs[k] - fromUs;
            while (part < us * PARTS / (untilUs - fromUs)) {
                start[++part] = n;
            }
            projection.goTo(projection.step(us));
            double atX = projection.x(window.x[k], window.y[k]);
            double atY = projection.y(window.x[k], window.y[k]);
            if (Squares.isTaken(atX, atY, fromUs, share)) {
                x[n] = MeetingPicture.place(atX);
                y[n] = MeetingPicture.place(atY);
                pixel[n] = length.pixel(window.x[k], window.y[k], window.polarity[k]);
                n++;
            }
        }
        while (part < PARTS) {
            start[++part] = n;
        }
        return n;
    }

    private int count(int segment, List<Slice> slices) {
        int events = 0;
        for (Slice each : slices) {
            if (each.untilUs > fromUs && each.fromUs < untilUs) {
                SegmentEvents own = each.bySegment(window);
                events += own.until(segment) - own.from(segment);
            }
        }
        return events;
    }

    /** Shifts the parts onto their common picture; returns whether the gain is worth it. */
    private boolean align() {
        shifts.clear();
        double before = pull();
        double least = LEAST_SIGMAS * MetricFit.sd(before);
        double after = before;
        for (int round = 0; round < ROUNDS; round++) {
            if (!shifts.step() || round == 0 && shifts.gain() < FIRST_SHARE * least) {
                return false;
            }
            if (shifts.gain() < NEXT_SHARE * least) {
                break;
            }
            after = pull();
        }
        // each meeting counts twice, once for each of its events
        return after - before > 2 * LEAST_SIGMAS * MetricFit.sd(after) && isFar();
    }

    private boolean isFar() {
        for (int part = 0; part < PARTS; part++) {
            if (Math.hypot(shifts.x(part), shifts.y(part)) >= LEAST_PX) {
                return true;
            }
        }
        return false;
    }

    /**
     * Finds the pull on each part: how often its events meet those of the others, in place and beside. Returns how
     * often they meet in place.
     */
    private double pull() {
        picture.clear();
        for (int part = 0; part < PARTS; part++) {
            draw(part, 1);
        }
        double sum = 0;
        for (int part = 0; part < PARTS; part++) {
            if (start[part] == start[part + 1]) {
                continue;
            }
            draw(part, -1);
            look(part);
            draw(part, 1);
            sum += met[4];
            shifts.pull(part, (met[5] - met[3]) / 2, (met[7] - met[1]) / 2, 2 * met[4] - met[3] - met[5],
                (met[2] + met[6] - met[0] - met[8]) / 4, 2 * met[4] - met[1] - met[7]);
        }
        return sum;
    }

    private void draw(int part, int weight) {
        int right = MeetingPicture.shift(shifts.x(part));
        int down = MeetingPicture.shift(shifts.y(part));
        for (int i = start[part]; i < start[part + 1]; i++) {
            picture.add(x[i] + right, y[i] + down, weight);
        }
    }

    /** Counts the events that those of a part meet where they are shifted to, and a px beside. */
    private void look(int part) {
        int right = MeetingPicture.shift(shifts.x(part));
        int down = MeetingPicture.shift(shifts.y(part));
        Arrays.fill(sums, 0);
        for (int i = start[part]; i < start[part + 1]; i++) {
            picture.addMeets(x[i] + right, y[i] + down, sums);
        }
        for (int k = 0; k < met.length; k++) {
            met[k] = Math.scalb((double) sums[k], -MeetingPicture.MET_BITS);
        }
    }

    /** Moves the events to where the bent path takes them. */
    private void moveByShifts() {
        for (int part = 0; part < PARTS; part++) {
            int right = MeetingPicture.shift(shifts.x(part));
            int down = MeetingPicture.shift(shifts.y(part));
            for (int i = start[part]; i < start[part + 1]; i++) {
                x[i] += right;
                y[i] += down;
            }
        }
    }

    /** The motions in the middle of each part that lies in a slice, with a multiple of the way of the bent path. */
    private List<Motion> knots(SegmentPath path, Slice slice, double times) {
        List<Motion> knots = new ArrayList<>();
        double seconds = (untilUs - fromUs) * 1e-6 / PARTS;
        for (int part = 0; part < PARTS; part++) {
            long afterUs = (untilUs - fromUs) * (2 * part + 1) / (2 * PARTS);
            if (fromUs + afterUs >= slice.fromUs && fromUs + afterUs < slice.untilUs) {
                int before = Math.max(0, part - 1);
                int after = Math.min(PARTS - 1, part + 1);
                double perS = 1 / ((after - before) * seconds);
                double vx = (shifts.x(after) - shifts.x(before)) * perS;
                double vy = (shifts.y(after) - shifts.y(before)) * perS;
                Motion motion = new Motion();
                path.at(fromUs + afterUs, motion);
                // at the reference time, the part is turned and grown by the motion in between
                projection.goTo(projection.step(afterUs));
                motion.vx -= projection.backX(vx, vy) - projection.backX(0, 0);
                motion.vy -= projection.backY(vx, vy) - projection.backY(0, 0);
                motion.vx *= times;
                motion.vy *= times;
                knots.add(motion);
            }
        }
        return knots;
    }
}
