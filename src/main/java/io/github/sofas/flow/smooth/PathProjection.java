package io.github.sofas.flow.smooth;

import io.github.sofas.flow.motion.Motion;

/**
 * Projects events of a segment along its path to a reference time, in steps of time. A path bends more than one motion
 * with its acceleration describes: a structure that swings once per second is 1 px off after 0.2 s.
 */
final class PathProjection {
    private static final int MOST_STEPS = 128;

    private final double[] cos = new double[MOST_STEPS];
    private final double[] sin = new double[MOST_STEPS];
    private final double[] shiftX = new double[MOST_STEPS];
    private final double[] shiftY = new double[MOST_STEPS];
    private final Motion motion = new Motion();
    // of the present step
    private double atCos;
    private double atSin;
    private double atShiftX;
    private double atShiftY;
    private long fromUs;
    private double stepsPerUs;
    private int steps;
    // composed so far: the transform from a time to the reference time
    private double c;
    private double s;
    private double wayX;
    private double wayY;

    /**
     * Begins with a path and a reference time.
     *
     * @param from first time that is asked for, in µs; not after the reference time
     * @param perUs steps per µs
     * @param count number of steps, at most {@value #MOST_STEPS}
     */
    void begin(SegmentPath path, long referenceUs, long from, double perUs, int count) {
        fromUs = from;
        stepsPerUs = perUs;
        steps = count;
        int first = Math.min(count, (int) Math.ceil((referenceUs - from) * perUs - 0.5));
        compose(path, referenceUs, first, count, 1);
        compose(path, referenceUs, first - 1, -1, -1);
    }

    /** Composes steps from the reference time on, forwards or backwards. */
    private void compose(SegmentPath path, long referenceUs, int first, int end, int by) {
        c = 1;
        s = 0;
        wayX = 0;
        wayY = 0;
        long us = referenceUs;
        for (int step = first; step != end; step += by) {
            long nextUs = fromUs + Math.round((step + 0.5) / stepsPerUs);
            path.at(us + (nextUs - us) / 2, motion);
            add((nextUs - us) * 1e-6);
            us = nextUs;
            cos[step] = c;
            sin[step] = s;
            shiftX[step] = wayX;
            shiftY[step] = wayY;
        }
    }

    /** Appends a step of so many seconds; the motion is that of its middle. */
    private void add(double seconds) {
        double shrunk = StrictMath.exp(-motion.growth * seconds);
        double stepC = shrunk * StrictMath.cos(motion.omega * seconds);
        double stepS = shrunk * StrictMath.sin(motion.omega * seconds);
        double halfX = 0.5 * seconds * motion.vx;
        double halfY = 0.5 * seconds * motion.vy;
        double toX = motion.centreX - halfX - stepC * (motion.centreX + halfX) - stepS * (motion.centreY + halfY);
        double toY = motion.centreY - halfY - stepC * (motion.centreY + halfY) + stepS * (motion.centreX + halfX);
        wayX += c * toX + s * toY;
        wayY += c * toY - s * toX;
        double newC = c * stepC - s * stepS;
        s = c * stepS + s * stepC;
        c = newC;
    }

    /** Step that contains a time, in µs since the first that is asked for. */
    int step(long us) {
        return Math.min(steps - 1, (int) (us * stepsPerUs));
    }

    /** Last time that the steps cover, in µs since the first that is asked for. */
    long lastUs() {
        return (long) (steps / stepsPerUs);
    }

    /** First time after a step, in µs since the first that is asked for; for the last step, a time that never comes. */
    long untilUs(int step) {
        if (step == steps - 1) {
            return Long.MAX_VALUE / 2;
        }
        long us = (long) ((step + 1) / stepsPerUs);
        while (step(us) > step) {
            us--;
        }
        while (step(us) <= step) {
            us++;
        }
        return us;
    }

    /** Goes to a step: from now on, places are projected from it, or back to it. */
    void goTo(int step) {
        atCos = cos[step];
        atSin = sin[step];
        atShiftX = shiftX[step];
        atShiftY = shiftY[step];
    }

    /** Column, at the reference time, of a place at the step. */
    double x(int atX, int atY) {
        return atCos * atX + atSin * atY + atShiftX;
    }

    /** Row. */
    double y(int atX, int atY) {
        return atCos * atY - atSin * atX + atShiftY;
    }

    /** Column, at the step, of a place at the reference time. */
    double backX(double x, double y) {
        return (atCos * (x - atShiftX) - atSin * (y - atShiftY)) / (atCos * atCos + atSin * atSin);
    }

    /** Row. */
    double backY(double x, double y) {
        return (atSin * (x - atShiftX) + atCos * (y - atShiftY)) / (atCos * atCos + atSin * atSin);
    }
}
