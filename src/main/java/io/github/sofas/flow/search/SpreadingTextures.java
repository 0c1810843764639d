package io.github.sofas.flow.search;

import java.util.ArrayDeque;

/**
 * Decides which structures of texture are due to look around themselves again for texture that moves alike: each
 * structure once in a few px of travel, at first more often. Ours, because a structure that is found early has not
 * shown all of itself yet, and texture that enters the picture later belongs to it, too.
 */
final class SpreadingTextures {
    /**
     * Travel between two looks around, in px: for the first looks, the number of these, and for the looks that follow.
     */
    private static final double FIRST_EVERY_PX = 1;
    private static final int FIRST = 4;
    private static final double EVERY_PX = 2;
    /** Speed in px/s below which a structure stands still, and shows nothing around itself. */
    private static final double LEAST_PX_PER_S = 1;

    private final ArrayDeque<Spreading> spreading = new ArrayDeque<>();
    /** Time when the next structure is due. */
    private long nextUs = Long.MAX_VALUE;

    private static final class Spreading {
        private final Structures.Structure structure;
        private long dueUs;
        /** Number of looks for which the structure has waited so far, including the next one. */
        private int waits;

        Spreading(Structures.Structure structure) {
            this.structure = structure;
        }
    }

    /** Adds a structure that has just looked around itself. */
    void add(Structures.Structure structure, long nowUs) {
        spreading.add(new Spreading(structure));
        wait(spreading.getLast(), nowUs);
    }

    private void wait(Spreading of, long nowUs) {
        double speed = Math.max(LEAST_PX_PER_S, of.structure.speed());
        double everyPx = of.waits++ < FIRST ? FIRST_EVERY_PX : EVERY_PX;
        of.dueUs = nowUs + (long) (everyPx / speed * 1e6);
        nextUs = Math.min(nextUs, of.dueUs);
    }

    /** Whether any structure may be due. */
    boolean isAnyDue(long nowUs) {
        return nowUs >= nextUs;
    }

    /** The next structure that is due, is still tracked and moves; null if there is none. */
    Structures.Structure due(long nowUs) {
        if (!isAnyDue(nowUs)) {
            return null;
        }
        nextUs = Long.MAX_VALUE;
        Structures.Structure due = null;
        for (int i = spreading.size(); i > 0; i--) {
            Spreading next = spreading.poll();
            if (next.structure.isTracked()) {
                spreading.add(next);
                if (due == null && nowUs >= next.dueUs) {
                    due = next.structure.speed() >= LEAST_PX_PER_S ? next.structure : null;
                    wait(next, nowUs);
                } else {
                    nextUs = Math.min(nextUs, next.dueUs);
                }
            }
        }
        return due;
    }

    /** Forgets all structures. */
    void clear() {
        spreading.clear();
        nextUs = Long.MAX_VALUE;
    }
}
