package io.github.sofas.flow.paper;

import java.util.Arrays;

/**
 * Counts how many events hit the occupied cells of each of the 3 x 3 projections of a track plane, and finds the best
 * projection, which becomes the new centre (paper, section Track Plane).
 */
final class Hits {
    private static final int SIDE = LiveEvents.SIDE;
    private static final int CENTRE = SIDE * SIDE / 2;

    private final int[] hits = new int[SIDE * SIDE];
    /** Offset of the best projection from the centre, in units of the distance between neighbouring projections. */
    private double bestX;
    private double bestY;

    void add(int k) {
        hits[k]++;
    }

    /**
     * Whether the hits of any projection pass a share of its occupied cells. If several pass at one event, the one with
     * the greatest share is best. Of equal ones the centre is best, or else their mean: to take the first would bias
     * all velocities in one direction.
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
