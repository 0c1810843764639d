package io.github.sofas.flow.search;

import java.util.ArrayDeque;

/**
 * Which structures of texture are due to look around themselves again for what moves alike: each once in a few px of
 * travel, at first more often. Ours, because what is found early has not shown all of itself yet, and what enters the
 * picture later is of it too.
 */
final class SpreadingTextures {
    /** Travel between two looks around, in px: of so many first ones, and of those that follow. */
    private static final double FIRST_EVERY_PX = 1;
    private static final int FIRST = 4;
    private static final double EVERY_PX = 2;
    /** Speed below which a structure stands, and shows nothing around itself, in px/s. */
    private static final double LEAST_PX_PER_S = 1;

    private final ArrayDeque<Spreading> spreading = new ArrayDeque<>();
    /** When the next one is due. */
    private long nextUs = Long.MAX_VALUE;

    private static final class Spreading {
        private final Structures.Structure structure;
        private long dueUs;
        /** Looks that it was to wait for so far. */
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

    /** The next structure that is due, is tracked yet and moves; null if none is. */
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
