package io.github.sofas.flow.smooth;

import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.motion.Deformation;
import io.github.sofas.flow.motion.Motion;

/**
 * The mean motion of a path about a time, near times counting most, over as much of both sides as has knots. Two
 * successive measurements have few events in common, and swing about the true motion.
 *
 * <p>A mean flattens what bends: the speed of a camera that jumps is a bell of a few px of travel. What the bend adds
 * to the velocity, as the parabola shows it that fits the same times best, is believed as far as it shifts the events
 * more than their noise does. Ours, because a shorter mean follows the bend, too, but with the noise of few events.
 */
final class PathMean {
    /** Most and least travel, and most time, on either side, and samples per side. */
    private static final double MOST_PX = 6;
    private static final double LEAST_PX = 1;
    private static final long MOST_US = 150_000;
    private static final int SAMPLES = 8;
    /**
     * Events of a side from which on its travel may be shorter: so many show a motion well, and what swings is slower
     * in the mean.
     */
    private static final int MANY_EVENTS = 2000;
    /** Shift by the bend within a side, in px times the root of its events, of which one half is believed. */
    private static final double NOISE_PX = 12;
    /** Weights of the samples at so many steps from the middle: of the mean, and of what the parabola adds to it. */
    private static final double[] MEAN = new double[SAMPLES];
    private static final double[] BEND = new double[SAMPLES];

    static {
        double squares = 0;
        double fourths = 0;
        for (int k = 1 - SAMPLES; k < SAMPLES; k++) {
            double weight = (double) (SAMPLES - Math.abs(k)) / (SAMPLES * SAMPLES);
            MEAN[Math.abs(k)] = weight;
            squares += weight * k * k;
            fourths += weight * k * k * k * k;
        }
        // of least squares: they add nothing to what changes evenly, and to a parabola what the mean takes from it
        for (int k = 0; k < SAMPLES; k++) {
            BEND[k] = MEAN[k] * squares * (squares - k * k) / (fourths - squares * squares);
        }
    }

    private final SegmentPath path;
    /** The motion that was asked for last. */
    private final Motion motion = new Motion();
    private final Motion sample = new Motion();
    private final Deformation deformation = new Deformation();
    private long fromUs;
    private long untilUs;

    PathMean(SegmentPath path) {
        this.path = path;
        forget();
    }

    /** Forgets the motion that was asked for last, because the path has changed. */
    void forget() {
        fromUs = 1;
        untilUs = 0;
    }

    /** The mean motion in the middle of the block of time that contains a time. The next call changes the result. */
    Motion about(long us, long blockUs) {
        if (us < fromUs || us >= untilUs) {
            fromUs = Math.floorDiv(us, blockUs) * blockUs;
            untilUs = fromUs + blockUs;
            average(fromUs + blockUs / 2);
        }
        return motion;
    }

    private void average(long us) {
        path.at(us, motion);
        long known = Math.min(us - path.first().referenceUs, path.last().referenceUs - us);
        double sideUs = Math.min(sideUs(), known);
        if (sideUs <= 0) {
            return;
        }
        double vx = 0;
        double vy = 0;
        double bendX = 0;
        double bendY = 0;
        double omega = 0;
        double growth = 0;
        deformation.clear();
        for (int k = 1 - SAMPLES; k < SAMPLES; k++) {
            path.at(us + (long) (sideUs * k / SAMPLES), motion, sample);
            double weight = MEAN[Math.abs(k)];
            double bend = BEND[Math.abs(k)];
            vx += weight * sample.vx;
            vy += weight * sample.vy;
            bendX += bend * sample.vx;
            bendY += bend * sample.vy;
            omega += weight * sample.omega;
            growth += weight * sample.growth;
            deformation.add(sample.deformation, weight);
        }
        double believed = MetricFit.shown(Math.hypot(bendX, bendY) * sideUs * 1e-6,
            NOISE_PX / Math.sqrt(sideUs / path.perEventUs()));
        motion.vx = vx + believed * bendX;
        motion.vy = vy + believed * bendY;
        motion.omega = omega;
        motion.growth = growth;
        motion.deformation.copyFrom(deformation);
    }

    /** Time on either side over which the motion is averaged, in µs, if there are knots. */
    private double sideUs() {
        double pxUs = 1e6 / path.speed(motion);
        double manyUs = Math.max(LEAST_PX * pxUs, MANY_EVENTS * path.perEventUs());
        return Math.min(MOST_US, Math.min(MOST_PX * pxUs, manyUs));
    }
}
