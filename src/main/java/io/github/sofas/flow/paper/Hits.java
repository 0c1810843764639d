package io.github.sofas.flow.paper;

import java.util.Arrays;

/** Which of the 3 x 3 projections the events hit most: the centre to be (section Track Plane). */
final class Hits {
    private static final int SIDE = LiveEvents.SIDE;
    private static final int CENTRE = SIDE * SIDE / 2;

    private final int[] hits = new int[SIDE * SIDE];
    /** Where the best projection lies from the centre, in distances of projections. */
    private double bestX;
    private double bestY;

    void add(int k) {
        hits[k]++;
    }

    /**
     * Whether a projection's hits pass a share of its cells. Of several that pass at one event the one with the
     * greatest share is best; of equal ones the centre, else their mean: taking the first would lean all velocities
     * one way.
     */
    boolean haveABest(double share, int[] cells) {
        int best = -1;
        for (int k = 0; k < hits.length; k++) {
            if (hits[k] > share * cells[k]
                    && (best < 0 || (long) hits[k] * cells[best] > (long) hits[best] * cells[k])) {
                best = k;
            }
        }
        if (best < 0) {
            return false;
        }
        bestX = 0;
        bestY = 0;
        int equals = 0;
        for (int k = 0; k < hits.length; k++) {
            if ((long) hits[k] * cells[best] == (long) hits[best] * cells[k]) {
                bestX += k % SIDE - 1;
                bestY += k / SIDE - 1;
                equals++;
                if (k == CENTRE) {
                    bestX = 0;
                    bestY = 0;
                    return true;
                }
            }
        }
        bestX /= equals;
        bestY /= equals;
        return true;
    }

    double bestX() {
        return bestX;
    }

    double bestY() {
        return bestY;
    }

    void clear() {
        Arrays.fill(hits, 0);
    }
}
