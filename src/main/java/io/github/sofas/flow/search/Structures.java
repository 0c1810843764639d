package io.github.sofas.flow.search;

import io.github.sofas.flow.motion.Motion;

/** Who tracks the structures that the search finds. */
public interface Structures {
    /** Whether no further structure can be tracked. */
    boolean isFull();

    /** Takes a new structure over, of a velocity in px/s at a time; its events follow. */
    Structure create(long nowUs, double vxPxPerS, double vyPxPerS);

    /** Whether one of the structures that were handed over of late expects an event, and takes it. */
    boolean takes(int x, int y, long timeUs, int polarity);

    /**
     * Tells of those that are tracked, whose motions predict their events and are known along both axes; not while
     * others track them.
     */
    void tell(Recognition to, long nowUs);

    /**
     * Notes an event of the past on the contour of one that is tracked, if it still is; not while others track it.
     *
     * @param id as it was told of
     */
    void see(int id, int x, int y, long timeUs, int polarity, long nowUs);

    /** A structure that is handed over. */
    interface Structure {
        /** Hands over an event of the structure's past, in order of time. */
        void addPast(int x, int y, long timeUs, int polarity);

        /** Begins to track it, with the events handed over so far. */
        void begin(long nowUs);

        /** Whether it expects an event, once it is tracked. */
        boolean expects(int x, int y, long timeUs, int polarity);

        /** Whether it is tracked yet, and not as a part of another. */
        boolean isTracked();

        /** Speed of its contour in px/s, root of the mean square. */
        double speed();

        /** Lets a motion be as its own is now. */
        void copyMotion(Motion motion);

        /** Whether a place of the sensor lies in its box, or beside it by so many px at most. */
        boolean isAround(int x, int y, double marginPx, long nowUs);

        /** Notes an event of the past on its contour, once it is tracked. */
        void see(int x, int y, long timeUs, int polarity, long nowUs);
    }
}
