package io.github.sofas.flow.track;

import io.github.sofas.flow.motion.Motion;

/**
 * When a motion turned back, or will turn back. From then on each edge fires events of the other polarity, as it goes
 * back over where it came from. Ours, because a contour expects the polarity that its edges fired recently. Also,
 * events from before and after the turn cancel each other where they meet, most of all along the true motion.
 */
final class Turn {
    /** Shares of the lifetime, after the turn and before it, in which events may have either polarity. */
    private static final double AFTER = 0.5;
    private static final double BEFORE = 0.2;

    private final Motion now = new Motion();
    /**
     * Time since the turn, in s: negative if the turn lies ahead, as for a motion that slows down; infinite for a
     * steady motion.
     */
    private double agoS;
    private long us;

    /** Takes a motion as it is known at a time. */
    void take(Motion motion, long nowUs) {
        now.copyFrom(motion);
        now.moveReference(nowUs);
        double square = now.vx * now.vx + now.vy * now.vy;
        // at rest it may go anywhere
        agoS = square == 0 ? 0 : square / (now.vx * now.ax + now.vy * now.ay);
        us = nowUs - (long) (agoS * 1e6);
    }

    /** Whether the motion turned not long ago, or may turn by now. */
    boolean isNear(long lifetimeUs) {
        double lifetimeS = lifetimeUs * 1e-6;
        return agoS > -BEFORE * lifetimeS && agoS < AFTER * lifetimeS;
    }

    /** Whether the motion turned after a time. */
    boolean isAfter(long fromUs) {
        return agoS > 0 && us > fromUs;
    }

    /** Time of the turn, in µs. */
    long us() {
        return us;
    }

    /** Polarity that the edge of an event fires since the turn. */
    int polarity(long timeUs, int polarity) {
        return timeUs < us ? -polarity : polarity;
    }
}
