package io.github.sofas.flow.search;

import java.util.Arrays;

/**
 * Events of the flow plane that a structure has received, and that are to be taken out of the rings: some at a time, so
 * that labelling continues in between.
 */
final class TakenEvents {
    private static final int AT_ONCE = VoteBlock.CAPACITY;

    private final FlowPlane plane;
    private final int rings;
    private int[] numbers = new int[4096];
    private int size;
    /** The ring from which events are taken out now, and the place of the next event. */
    private int ring;
    private int next;

    TakenEvents(FlowPlane plane) {
        this.plane = plane;
        rings = plane.projections().n();
    }

    /** Forgets all events. */
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

    /** Whether all events are taken out of all rings. */
    boolean isOver() {
        return ring == rings;
    }

    /** Takes some events out of the next ring; returns how many. */
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
