package io.github.sofas.flow.track;

import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.motion.Motion;

/**
 * Whether a structure is one body. The question is asked each few px of its travel ({@link PartingSchedule}). A
 * structure that clearly is one body is believed to turn and grow as all of it shows.
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

    /** Whether a structure of some speed has travelled so far since the last question that it is asked now. */
    boolean beginsToAsk(double speed, long nowUs) {
        boolean isDue = schedule.isDue(speed, nowUs);
        if (isDue) {
            schedule.begin(nowUs);
        }
        return isDue;
    }

    /**
     * Looks for a part of the structure that is a body of its own, and notes if the structure is clearly one body. Only
     * some tiles of a dense structure are known, so that nothing can be seen to lie apart, and nothing is given up.
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
     * Whether the structure is two bodies that seem to turn or grow together; notes if it is clearly one. A structure
     * that is not believed to turn is asked with the rotation and growth that all of it shows. It may prove to be one
     * body, but is not given up for two.
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
