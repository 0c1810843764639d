package io.github.sofas.flow.track;

import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.motion.Motion;

/**
 * Whether a structure is one body: asked each few px of its travel ({@link PartingSchedule}). What clearly is one is
 * believed to turn and grow as all of it shows.
 */
final class Wholeness {
    private final PartingSchedule schedule = new PartingSchedule();
    /** The motion as it is if the structure is one body. */
    private final Motion ofOne = new Motion();

    /** Begins with a structure that was found. */
    void start(long nowUs) {
        schedule.start(nowUs);
    }

    /** Begins anew with a structure that has become another one. */
    void doubt() {
        schedule.askSoonForTwo();
    }

    /** Whether a structure of some speed has travelled so far since it was asked last that it is asked now. */
    boolean beginsToAsk(double speed, long nowUs) {
        boolean isDue = schedule.isDue(speed, nowUs);
        if (isDue) {
            schedule.begin(nowUs);
        }
        return isDue;
    }

    /**
     * Looks whether a part of the structure is a body of its own, and notes if it is clearly one body. Of a dense
     * structure only some tiles are known, by which nothing lies apart, and nothing is given up.
     *
     * @return whether there is a part, which is to be given up to another plane
     */
    boolean findPart(Parting parting, LiveEvents live, Motion motion, double radius, Measurement measurement,
                     MetricFit fit) {
        boolean hasAllTiles = live.thinning() == 1;
        boolean mayBeTwo = schedule.isForTwo() && measurement.isPredictive() && measurement.isSharp();
        if (hasAllTiles && parting.findApart(live, motion, radius, fit)) {
            if (mayBeTwo) {
                schedule.note(false);
            }
            return true;
        }
        return mayBeTwo && areTwo(parting, live, motion, radius, measurement, fit) && hasAllTiles;
    }

    /**
     * Whether it is two bodies that seem to turn or grow together; notes if it is clearly one. What is not believed to
     * turn is asked with rotation and growth as all of it shows them: it may be one, but is not given up for two.
     */
    private boolean areTwo(Parting parting, LiveEvents live, Motion motion, double radius, Measurement measurement,
                           MetricFit fit) {
        boolean areTwo = parting.findTwo(live, motion, radius, fit);
        if (!parting.turns()) {
            ofOne.copyFrom(motion);
            ofOne.moveReference(live.middleUs());
            measurement.applyOfAll(ofOne);
            parting.findTwo(live, ofOne, radius, fit);
        }
        if (parting.isClearlyOne()) {
            measurement.believeAll();
        }
        schedule.note(parting.isClearlyOne());
        return areTwo;
    }
}
