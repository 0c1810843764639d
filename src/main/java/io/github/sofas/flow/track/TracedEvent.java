package io.github.sofas.flow.track;

import java.util.Arrays;

/**
 * The event that is being labelled, and how far its edge came along the motions of planes. Each is asked for once: a
 * trace looks at up to four pixels for every px of travel. Ours, as {@link PixelHistory} is.
 */
final class TracedEvent {
    private final PixelHistory history;
    int x;
    int y;
    long timeUs;
    int polarity;
    /** Planes whose traces are known. */
    private TrackPlane[] planes = new TrackPlane[16];
    private int[] traces = new int[16];
    private int size;

    TracedEvent(PixelHistory history) {
        this.history = history;
    }

    /** Begins with an event. */
    void begin(int itsX, int itsY, long itsTimeUs, int itsPolarity) {
        x = itsX;
        y = itsY;
        timeUs = itsTimeUs;
        polarity = itsPolarity;
        size = 0;
    }

    /** Whether it is one in so many, as its place and time have it. */
    boolean isOneIn(int many) {
        return (x ^ y ^ timeUs) % many == 0;
    }

    /** How far its edge came along the motion of a plane, as {@link PixelHistory#traceBeyond}. */
    int trace(TrackPlane plane) {
        return traceBeyond(-1, plane);
    }

    /** The same, if it is more than a trace that is known; else any that is no more than it. */
    int traceBeyond(int known, TrackPlane plane) {
        for (int i = 0; i < size; i++) {
            if (planes[i] == plane) {
                return traces[i];
            }
        }
        int its = history.traceBeyond(known, x, y, timeUs, polarity, plane.motion());
        if (its > known) {
            note(plane, its);
        }
        return its;
    }

    private void note(TrackPlane plane, int trace) {
        if (size == planes.length) {
            planes = Arrays.copyOf(planes, 2 * size);
            traces = Arrays.copyOf(traces, 2 * size);
        }
        planes[size] = plane;
        traces[size++] = trace;
    }

    /** Whether it may have come from beyond the border of the sensor just before. */
    boolean isNearBorder() {
        return history.isNearBorder(x, y);
    }

    /** Whether it did along the motion of a plane. */
    boolean cameIn(TrackPlane plane) {
        return history.cameIn(x, y, timeUs, plane.motion());
    }

    /** Sixteenths of the live time in which a plane's contour was where it is, as {@link TrackPlane#support}. */
    int support(TrackPlane plane) {
        return plane.support(x, y, timeUs, polarity);
    }
}
