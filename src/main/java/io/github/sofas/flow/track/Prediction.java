package io.github.sofas.flow.track;

/**
 * Whether the motion of a structure predicts its events: whether they meet more often along it than where they are.
 * Ours, because a motion that has run away, as it does where something small turns back, goes on to label what happens
 * to lie on its contour. It is the yardstick of flow without a truth (flow warp loss, Stoffregen et al. 2020), as far
 * as the past tells it.
 *
 * <p>Measuring climbs to the best of many velocities, so that along a motion that is none events meet a little more
 * often than at rest: by a tenth or a fifth where a light trembles or flickers. Of structures it is by a half and more.
 * Where only noise comes, but much of it from a small part of the sensor, they meet no more than by chance either way.
 */
final class Prediction {
    /** Metric along a motion that predicts the events, as a multiple of that at rest, at least. */
    private static final double PREDICTS = 1.1;
    /** Metric per event along it, at least: one of a hundred measurements of structures has less than 0.2, noise 0. */
    private static final double LEAST_DENSITY = 0.1;
    /** Travel over the window below which both are as good, in px. */
    private static final double LEAST_TRAVEL_PX = 2;
    /** Standard deviations that may be chance: a metric of m, or one of m events by chance, has sqrt(m). */
    private static final double CHANCE_SIGMAS = 1;
    /** Travel against the events after which there is no structure that moves like this, in px. */
    private static final double WRONG_PX = 5;

    /** Metric along the motion, as a multiple of that at rest, of what is judged less often. */
    private static final double SURE = 1.5;
    /** Part of the live events that must have gone before what is sure is judged again. */
    private static final int SURE_PART = 2;

    private boolean holds;
    private double wrongPx;
    private long judgedUs;
    private long sureUntilUs = Long.MIN_VALUE;

    /** Begins with a motion that is new, and not to be judged before it is measured again. */
    void restart() {
        holds = true;
        wrongPx = 0;
        judgedUs = 0;
        sureUntilUs = Long.MIN_VALUE;
    }

    /** Whether the events meet along the motion, and more than at rest; else it tells nothing of them for now. */
    boolean holds() {
        return holds;
    }

    /** Whether they have contradicted it for so long that there is no structure, or none that moves like this. */
    boolean isRefuted() {
        return wrongPx > WRONG_PX;
    }

    /**
     * Judges the motion.
     *
     * @param along metric of the live events moved along the motion
     * @param atRest metric of the same events where they are
     * @param events how many there are
     * @param speed of the motion in px/s
     * @param windowUs time that the live events span
     */
    void judge(double along, double atRest, int events, double speed, long windowUs, long nowUs) {
        boolean meets = along >= LEAST_DENSITY * events - CHANCE_SIGMAS * Math.sqrt(events);
        holds = meets && (along >= PREDICTS * atRest || speed * windowUs * 1e-6 <= LEAST_TRAVEL_PX);
        if (holds) {
            wrongPx = 0;
        } else if (atRest - along > CHANCE_SIGMAS * Math.sqrt(atRest) && judgedUs != 0) {
            wrongPx += speed * (nowUs - judgedUs) * 1e-6;
        }
        judgedUs = nowUs;
        sureUntilUs = along > SURE * atRest ? nowUs + windowUs / SURE_PART : nowUs;
    }

    /** Whether it was judged not long ago by events that left no doubt. */
    boolean isSure(long nowUs) {
        return nowUs < sureUntilUs;
    }
}
