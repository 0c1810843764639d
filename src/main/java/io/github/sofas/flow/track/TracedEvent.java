package io.github.sofas.flow.track;

import java.util.Arrays;

/**
 * The event that is being labelled, and how far its edge came along the motions of planes. Each trace is computed only
 * once, because it looks at up to four pixels per px of travel. Ours, as {@link PixelHistory} is.
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

    /** Whether the event is one in so many, chosen by its place and time. */
    boolean isOneIn(int many) {
        return (x ^ y ^ timeUs) % many == 0;
    }

    /** How far the edge of the event came along the motion of a plane, as {@link PixelHistory#traceBeyond}. */
    int trace(TrackPlane plane) {
        return traceBeyond(-1, plane);
    }

    /** The same trace if it exceeds a known one; else any value that does not exceed that. */
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

    /** Whether the event may just have come from beyond the border of the sensor. */
    boolean isNearBorder() {
        return history.isNearBorder(x, y);
    }

    /** Whether the event just came from beyond the border along the motion of a plane. */
    boolean cameIn(TrackPlane plane) {
        return history.cameIn(x, y, timeUs, plane.motion());
    }

    /**
     * Support of the event by the sixteenths of the live time in which a plane's contour was there:
     * {@link TrackPlane#support}.
     */
    int support(TrackPlane plane) {
        return plane.support(x, y, timeUs, polarity);
    }
}
