package io.github.sofas.flow.motion;

/**
 * The projection of an event along a velocity (paper, section Structure Detection): (u, v, t) falls on
 * (u - vx (t - t0), v - vy (t - t0)). This is the one place that fixes sign and units: velocity in px/s, positive to
 * the right and down; t0 is the time at which the projected plane shows the sensor as it is.
 *
 * <p>Shifts are fixed-point products, so that the same event always falls on the same cell, whoever asks and whenever.
 */
public final class Projection {
    /** Fraction bits of a velocity in px/µs: steps of 0.004 px/s, and room for 5,000,000 px/s in an int. */
    static final int BITS = 28;
    private static final long HALF = 1L << (BITS - 1);

    private Projection() {
    }

    /** A velocity in px/s as fixed-point px/µs. */
    public static int fixed(double pxPerS) {
        return (int) Math.round(pxPerS * 1e-6 * (1L << BITS));
    }

    /** Whole pixels travelled in a time, to the nearest. */
    public static int travelled(int fixedVelocity, long timeUs) {
        return (int) ((fixedVelocity * timeUs + HALF) >> BITS);
    }
}
