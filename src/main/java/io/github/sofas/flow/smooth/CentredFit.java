package io.github.sofas.flow.smooth;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.SofasParameters;
import io.github.sofas.flow.fit.CentredStep;
import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.motion.Motion;
import io.github.sofas.flow.motion.SteppedProjection;
import java.util.List;

/**
 * Measures the motion of a segment that turns or grows, from its events on both sides of a time. The engine knows one
 * side only, so that it takes small rotations and growths for noise and follows them with a lag. Its velocities are
 * known better, and are right in the middle of their windows.
 */
final class CentredFit {
    /** Most events that are wanted for a measurement; there is room for twice as many. */
    private static final int WANTED = 4000;
    private static final int LEAST = 30;
    private static final int MOST_ON_BOTH = 1900;
    private static final int ROUNDS = 2;
    /** Shift of an end of the window by a step, in px, below which a further step would follow noise. */
    private static final double ENOUGH_PX = 0.1;
    /** Step, in px, by which events are projected for a measurement. */
    private static final double STEP_PX = 1.0 / 64;
    /**
     * Parts of the window, and, as bits, those measured where events are many: events that follow at once show no
     * velocity.
     */
    private static final int PARTS = 8;
    private static final int MEASURED_PARTS = 0b10100101;

    private final EventWindow window;
    private final SegmentCursor cursor;
    private final MetricFit fit;
    private final CentredStep step;
    private final SteppedProjection projection = new SteppedProjection();
    private final Motion motion = new Motion();
    private final Motion before = new Motion();
    private double radius;

    CentredFit(SensorSize sensor, EventWindow window, SofasParameters.Track p) {
        this.window = window;
        cursor = new SegmentCursor(window);
        fit = new MetricFit(sensor.width(), sensor.height(), MetricFit.CELL_PX, 2 * WANTED, MOST_ON_BOTH);
        step = new CentredStep(p);
    }

    /** Bytes of its arrays. */
    static long bytes(SensorSize sensor) {
        return MetricFit.bytes(sensor.width(), sensor.height(), MetricFit.CELL_PX, 2 * WANTED);
    }

    /**
     * Measures the motion of a path at a time.
     *
     * @param slices the slices around that time, in order
     * @param sideUs half the window in µs
     * @param leastEvents fewest events to measure from, if that is more than the fewest that any measurement needs
     * @return the motion, valid until the next call; null where there are too few events
     */
    Motion measure(SegmentPath path, List<Slice> slices, long us, long sideUs, int leastEvents) {
        path.bending(us, Math.max(1, sideUs / 2), motion);
        int events = lookAt(path, slices, us, sideUs);
        if (events < Math.max(LEAST, leastEvents)) {
            return null;
        }
        double half = sideUs * 1e-6;
        step.begin();
        for (int round = 0; round < ROUNDS; round++) {
            load(path, slices, us, sideUs, events);
            if (fit.size() < LEAST) {
                return null;
            }
            before.copyFrom(motion);
            step.take(fit, motion, half, radius);
            if (stepPx(half) < ENOUGH_PX) {
                break;
            }
        }
        return motion;
    }

    /** How far the last step shifts an end of the window, in px, by that part of the motion which it changes most. */
    private double stepPx(double half) {
        double bend = half * half / 2;
        double velocity = Math.hypot(motion.vx - before.vx, motion.vy - before.vy) * half;
        double acceleration = Math.hypot(motion.ax - before.ax, motion.ay - before.ay) * bend;
        double turn = Math.hypot(motion.omega - before.omega, motion.growth - before.growth) * radius * half;
        double spin = Math.abs(motion.alpha - before.alpha) * radius * bend;
        return Math.max(Math.max(velocity, acceleration), Math.max(turn, spin));
    }

    /**
     * Counts the segment's events in the window, moves the centre of the motion to their middle, and finds their
     * radius.
     */
    private int lookAt(SegmentPath path, List<Slice> slices, long us, long sideUs) {
        int n = 0;
        double sumX = 0;
        double sumY = 0;
        double squares = 0;
        projection.begin(motion, sideUs, 1, 1);
        cursor.begin(slices, path.id(), us - sideUs + 1, us + sideUs);
        for (int k = cursor.next(); k != SegmentCursor.NONE; k = cursor.next()) {
            projection.advance(window.timeUs[k]);
            double x = projection.x(window.x[k], window.y[k]);
            double y = projection.y(window.x[k], window.y[k]);
            n++;
            sumX += x;
            sumY += y;
            squares += x * x + y * y;
        }
        if (n > 0) {
            motion.moveCentre(sumX / n, sumY / n);
            radius = Math.sqrt(Math.max(0, (squares - (sumX * sumX + sumY * sumY) / n) / n));
        }
        return n;
    }

    private void load(SegmentPath path, List<Slice> slices, long us, long sideUs, int events) {
        fit.clear();
        boolean many = events > WANTED;
        // half of the window, and there the share of squares that holds as many events as are wanted
        long share = Squares.share(events, 2 * WANTED);
        projection.begin(motion, sideUs, 2 * radius, STEP_PX);
        cursor.begin(slices, path.id(), us - sideUs + 1, us + sideUs);
        for (int k = cursor.next(); k != SegmentCursor.NONE && fit.size() < fit.capacity(); k = cursor.next()) {
            long fromUs = window.timeUs[k] - us;
            if (many && (MEASURED_PARTS >> (fromUs + sideUs) * PARTS / (2 * sideUs) & 1) == 0) {
                continue;
            }
            projection.advance(window.timeUs[k]);
            double x = projection.x(window.x[k], window.y[k]);
            double y = projection.y(window.x[k], window.y[k]);
            if (Squares.isTaken(x, y, us, share)) {
                fit.add(motion, x, y, fromUs * 1e-6, window.polarity[k]);
            }
        }
    }
}
