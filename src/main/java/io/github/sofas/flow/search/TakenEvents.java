package io.github.sofas.flow.search;

import java.util.Arrays;

/** Events of the flow plane that a structure has got, and that are to be taken out of its rings: some at a time. */
final class TakenEvents {
    private static final int AT_ONCE = VoteBlock.CAPACITY;

    private final FlowPlane plane;
    private final int rings;
    private int[] numbers = new int[4096];
    private int size;
    /** The ring that they are taken out of, and the place of the next one. */
    private int ring;
    private int next;

    TakenEvents(FlowPlane plane) {
        this.plane = plane;
        rings = plane.projections().n();
    }

    /** Begins with none. */
    void clear() {
        size = 0;
        ring = 0;
        next = 0;
    }

    /** Adds an event by its number. */
    void add(int event) {
        if (size == numbers.length) {
            numbers = Arrays.copyOf(numbers, 2 * size);
        }
        numbers[size++] = event;
    }

    int size() {
        return size;
    }

    /** Whether all are taken out of all rings. */
    boolean isOver() {
        return ring == rings;
    }

    /** Takes some of them out of the next ring; returns how many. */
    int takeOut() {
        int end = Math.min(size, next + AT_ONCE);
        int count = end - next;
        plane.takeOut(ring, numbers, next, end);
        next = end;
        if (next == size) {
            next = 0;
            ring++;
        }
        return count;
    }
}
