package io.github.sofas.flow.track;

/**
 * Whether the motion of a structure predicts its events: whether they meet more often along it than where they are.
 * Ours, because a motion that has run away, as it does where a small structure reverses, goes on to label what happens
 * to lie on its contour. The criterion is the yardstick of flow without ground truth (flow warp loss, Stoffregen et al.
 * 2020), as far as past events show it.
 *
 * <p>Measuring climbs to the best of many velocities. Even where nothing moves, events therefore meet a little more
 * often along the measured motion than at rest: by a tenth or a fifth where a light trembles or flickers. Those of
 * structures do by a half and more. Where only noise comes, but much of it from a small part of the sensor, events meet
 * no more than by chance either way.
 */
final class Prediction {
    /** Least metric along a motion that predicts the events, as a multiple of that at rest. */
    private static final double PREDICTS = 1.1;
    /**
     * Least metric per event along such a motion: one in a hundred measurements of structures has less than 0.2, noise
     * has 0.
     */
    private static final double LEAST_DENSITY = 0.1;
    /** Travel over the window, in px, below which the motion and rest are equally good. */
    private static final double LEAST_TRAVEL_PX = 2;
    /**
     * Standard deviations that may be chance. A metric of m has sqrt(m), as has the metric of m events that meet by
     * chance.
     */
    private static final double CHANCE_SIGMAS = 1;
    /** Travel that the events contradict, in px, after which there is no structure that moves like this. */
    private static final double WRONG_PX = 5;

    /**
     * Metric along the motion, as a multiple of that at rest, above which the motion is sure and is judged less often.
     */
    private static final double SURE = 1.5;
    /** Part of the live events that must have gone before a sure motion is judged again. */
    private static final int SURE_PART = 2;

    private boolean holds;
    private double wrongPx;
    private long judgedUs;
    private long sureUntilUs = Long.MIN_VALUE;

    /** Begins with a new motion, which is not to be judged before it is measured again. */
    void restart() {
        holds = true;
        wrongPx = 0;
        judgedUs = 0;
        sureUntilUs = Long.MIN_VALUE;
    }

    /**
     * Whether the events meet along the motion, and more often than at rest. If not, the motion predicts nothing for
     * now.
     */
    boolean holds() {
        return holds;
    }

    /**
     * Whether the events have contradicted the motion for so long that there is no structure, or none that moves like
     * this.
     */
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

    /** Whether the motion was judged not long ago, by events that left no doubt. */
    boolean isSure(long nowUs) {
        return nowUs < sureUntilUs;
    }
}
