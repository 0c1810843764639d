package io.github.sofas.flow.motion;

/**
 * The projection of an event along a velocity (paper, section Structure Detection): the event (u, v, t) falls on
 * (u - vx (t - t0), v - vy (t - t0)). This class alone fixes signs and units. Velocities are in px/s, positive to the
 * right and down. At the reference time t0, the projected plane shows the sensor as it is.
 *
 * <p>Shifts are fixed-point products, so that the same event always falls on the same cell, whichever class projects
 * it, and whenever.
 */
public final class Projection {
    /** Fraction bits of a velocity in px/µs: steps of 0.004 px/s, with room for 5,000,000 px/s in an int. */
    static final int BITS = 28;
    private static final long HALF = 1L << (BITS - 1);

    private Projection() {
    }

    /** Converts a velocity in px/s to fixed-point px/µs. */
    public static int fixed(double pxPerS) {
        return (int) Math.round(pxPerS * 1e-6 * (1L << BITS));
    }

    /** Travel within a time, rounded to whole px. */
    public static int travelled(int fixedVelocity, long timeUs) {
        return (int) ((fixedVelocity * timeUs + HALF) >> BITS);
    }
}
