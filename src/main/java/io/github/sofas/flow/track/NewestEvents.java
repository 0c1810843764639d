package io.github.sofas.flow.track;

import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.motion.Motion;
import io.github.sofas.flow.motion.SteppedProjection;

/** The newest events of a structure, projected along a motion that they may show. */
final class NewestEvents {
    /** Most events that are used; of more, only those on a part of the tiles. */
    private static final int MOST_EVENTS = 3000;
    /** Step, in px, by which events are projected along the motion. */
    private static final double STEP_PX = 1.0 / 32;

    private final SteppedProjection stepped = new SteppedProjection();

    /**
     * Loads the newest events that are the structure's own.
     *
     * @param newest number of the newest live events
     * @param along motion that they are projected along, to its reference
     * @param radius of the structure in px
     */
    void load(LiveEvents live, int newest, Motion along, double radius, MetricFit fit) {
        int halvings = 0;
        while (newest >> halvings > MOST_EVENTS) {
            halvings++;
        }
        fit.clear();
        long fromUs = live.newestFromUs(newest);
        stepped.begin(along, Math.abs(along.referenceUs - fromUs), 2 * radius, STEP_PX);
        for (int k = live.size() - newest; k < live.size() && fit.size() < fit.capacity(); k++) {
            int i = live.index(k);
            if (live.isLeftBy(halvings, i) && live.claim(i) == Claim.OWN) {
                stepped.advance(live.timeUs[i]);
                fit.add((float) stepped.x(live.x[i], live.y[i]), (float) stepped.y(live.x[i], live.y[i]),
                    (live.timeUs[i] - along.referenceUs) * 1e-6f, 0, 0, live.sign[i]);
            }
        }
    }
}
