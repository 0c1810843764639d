package io.github.sofas.flow.track;

import io.github.sofas.flow.motion.Motion;

/** How far a structure has come along its motion recently. */
final class PastTravel {
    /** Parts of the time, in the middle of which the speed is evaluated. */
    private static final int PARTS = 4;

    private final Motion past = new Motion();

    /** The structure's events per px of its travel, over the time of its live events. */
    double eventsPerPx(Motion motion, LiveEvents live, double radius, long nowUs) {
        return live.size() / px(motion, radius, live.oldestUs(), nowUs);
    }

    /**
     * Travel from a time until now, in px.
     *
     * @param radius of the structure in px
     */
    double px(Motion motion, double radius, long fromUs, long nowUs) {
        long us = nowUs - fromUs;
        past.copyFrom(motion);
        double speeds = 0;
        for (int i = 0; i < PARTS; i++) {
            past.moveReference(nowUs - us * (2 * i + 1) / (2 * PARTS));
            speeds += past.speed(radius);
        }
        return speeds / PARTS * us * 1e-6;
    }
}
