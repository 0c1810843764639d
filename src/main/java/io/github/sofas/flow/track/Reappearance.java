package io.github.sofas.flow.track;

import io.github.sofas.flow.motion.Motion;

/**
 * Recognises a structure that was lost, because it turned round, stopped, or was hidden, in a new one: most of the new
 * contour lies where the lost one would be, had it travelled less far than was thought, or back. Ours, because what
 * turns round in front of the camera is still the same thing.
 */
final class Reappearance {
    private static final int SAMPLE = 128;
    /** Step of the search in px: the memory of a shape is kept on cells of that size. */
    private static final int STEP_PX = 2;
    /** How far beside its path a structure is looked for, in px. */
    private static final int BESIDE_PX = 4;
    /** How far behind the place where it was seen last, in px: a new structure is found after some travel. */
    private static final int BEHIND_PX = 12;

    private final int[] column = new int[SAMPLE];
    private final int[] row = new int[SAMPLE];
    private int size;
    private double shiftX;
    private double shiftY;

    /** Loads the contour of a new structure. */
    void load(LiveEvents live, Contour contour) {
        size = 0;
        int stride = Math.max(1, (live.size() + SAMPLE - 1) / SAMPLE);
        for (int k = 0; k < live.size(); k += stride) {
            int cell = live.cell[live.index(k)];
            if (cell >= 0) {
                column[size] = contour.column(cell);
                row[size] = contour.row(cell);
                size++;
            }
        }
    }

    /**
     * Looks for the new contour on a remembered shape, at any place back along its path.
     *
     * @param shape carried on by its last motion until now
     * @param lostPx travel since it was seen last
     * @return the greatest share of the contour that falls on the shape; 0 to 1
     */
    double search(Shape shape, Motion motion, double lostPx, long nowUs) {
        double speed = StrictMath.hypot(motion.vx, motion.vy);
        double ux = speed > 0 ? motion.vx / speed : 0;
        double uy = speed > 0 ? motion.vy / speed : 0;
        double best = 0;
        for (double back = 0; back <= lostPx + BEHIND_PX; back += STEP_PX) {
            for (int beside = -BESIDE_PX; beside <= BESIDE_PX; beside += STEP_PX) {
                double dx = back * ux - beside * uy;
                double dy = back * uy + beside * ux;
                double share = overlap(shape, dx, dy, nowUs);
                if (share > best) {
                    best = share;
                    shiftX = -dx;
                    shiftY = -dy;
                }
            }
        }
        return best;
    }

    /** Share of the new contour that would fall on a shape if it lay (dx, dy) px from where it is; 0 to 1. */
    double overlap(Shape shape, double dx, double dy, long nowUs) {
        int hits = 0;
        for (int i = 0; i < size; i++) {
            if (shape.wasSeen(column[i] + dx, row[i] + dy, nowUs)) {
                hits++;
            }
        }
        return size == 0 ? 0 : (double) hits / size;
    }

    /** From where the lost structure was thought to be to where it is, as the last search found, x in px. */
    double shiftX() {
        return shiftX;
    }

    double shiftY() {
        return shiftY;
    }
}
