package io.github.sofas.flow.search;

import io.github.sofas.flow.motion.Motion;

/**
 * Receives the structures that the search finds, and tracks them. The search knows the tracking only by this interface.
 */
public interface Structures {
    /** Whether no further structure can be tracked. */
    boolean isFull();

    /** Takes over a new structure, which has a velocity in px/s at a time. Its events follow. */
    Structure create(long nowUs, double vxPxPerS, double vyPxPerS);

    /** Whether a structure that was handed over recently expects an event, and takes it. */
    boolean takes(int x, int y, long timeUs, int polarity);

    /**
     * Reports the tracked structures whose motions predict their events and are known along both axes. Not to be called
     * while another thread tracks them.
     */
    void report(Recognition to, long nowUs);

    /**
     * Notes an event of the past on the contour of a structure, if the structure is still tracked. Not to be called
     * while another thread tracks it.
     *
     * @param id number by which the structure was reported
     */
    void see(int id, int x, int y, long timeUs, int polarity, long nowUs);

    /** A structure that is handed over. */
    interface Structure {
        /** Hands over an event of the structure's past, in order of time. */
        void addPast(int x, int y, long timeUs, int polarity);

        /** Begins to track the structure, with the events handed over so far. */
        void begin(long nowUs);

        /** Whether the structure expects an event, once it is tracked. */
        boolean expects(int x, int y, long timeUs, int polarity);

        /** Whether the structure is still tracked, and not as a part of another. */
        boolean isTracked();

        /** Speed of the contour in px/s, the root of the mean square. */
        double speed();

        /** Copies the present motion of the structure to another motion. */
        void copyMotion(Motion motion);

        /** Whether a place of the sensor lies in the box of the structure, or at most a margin in px beside it. */
        boolean isAround(int x, int y, double marginPx, long nowUs);

        /** Notes an event of the past on the contour, once the structure is tracked. */
        void see(int x, int y, long timeUs, int polarity, long nowUs);
    }
}
