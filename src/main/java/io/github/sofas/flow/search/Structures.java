package io.github.sofas.flow.search;

/** Who tracks the structures that the search finds. */
public interface Structures {
    /** Whether no further structure can be tracked. */
    boolean isFull();

    /** Takes a new structure over, of a velocity in px/s at a time; its events follow. */
    Structure create(long nowUs, double vxPxPerS, double vyPxPerS);

    /** A structure that is handed over. */
    interface Structure {
        /** Hands over an event of the structure's past, in order of time. */
        void addPast(int x, int y, long timeUs, int polarity);

        /** Begins to track it, with the events handed over so far. */
        void begin(long nowUs);

        /** Whether it expects an event, once it is tracked. */
        boolean expects(int x, int y, long timeUs, int polarity);
    }
}
