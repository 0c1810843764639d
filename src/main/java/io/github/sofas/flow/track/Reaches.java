package io.github.sofas.flow.track;

import java.util.Arrays;

/**
 * Boxes on the sensor that the contours of track planes do not leave for a time. An event is offered only to the planes
 * whose box it lies in. Ours, because a crowd has many planes, of which one or two are near an event. Looking an event
 * up on a contour costs several times as much as comparing it with a box.
 *
 * <p>A box is one {@code long} of four fields of 16 bits: its left side, its top, and the differences of its right side
 * and of its bottom from the greatest number of 15 bits. An event lies in the box if none of the event's four fields is
 * less than that of the box. With the highest bit of each field of the event set, one subtraction compares all four: a
 * field that is less loses that bit.
 */
final class Reaches {
    /** The box of a contour that no event can lie on. */
    static final long NOWHERE = 0x7fff_7fff_7fff_7fffL;
    private static final int MOST = Short.MAX_VALUE;
    private static final long HIGHEST_BITS = 0x8000_8000_8000_8000L;

    private long[] boxes = new long[16];
    private long untilUs;
    private boolean known;

    /** A box from one column and row to others, both inclusive; what lies beyond 0 and 32,766 is cut off. */
    static long box(double left, double top, double right, double bottom) {
        return pack(cut(left), cut(top), MOST - cut(right), MOST - cut(bottom));
    }

    private static int cut(double place) {
        return (int) Math.max(0, Math.min(MOST - 1, place));
    }

    private static long pack(int a, int b, int c, int d) {
        return (long) a << 48 | (long) b << 32 | c << 16 | d;
    }

    /** An event, packed for {@link #hold}. */
    static long event(int x, int y) {
        return pack(x, y, MOST - x, MOST - y) | HIGHEST_BITS;
    }

    /** Whether the boxes are known and hold for a time. */
    boolean areKnownAt(long timeUs) {
        return known && timeUs <= untilUs;
    }

    /** Takes the boxes of all planes, which none of their contours leaves until a time. */
    void take(TrackPlane[] planes, int size, long nowUs, long lastUs) {
        known = true;
        untilUs = lastUs;
        if (boxes.length < size) {
            boxes = Arrays.copyOf(boxes, planes.length);
        }
        for (int k = 0; k < size; k++) {
            boxes[k] = planes[k].contour().reach(nowUs, untilUs);
        }
    }

    /**
     * Takes the box of a plane anew if its contour has changed, and the plane is one of those whose boxes are known.
     */
    void follow(TrackPlane plane, TrackPlane[] planes, int size, long nowUs) {
        if (!known || !plane.contour().hasChangedReach()) {
            return;
        }
        for (int k = 0; k < size; k++) {
            if (planes[k] == plane) {
                boxes[k] = plane.contour().reach(nowUs, untilUs);
            }
        }
    }

    /** Forgets all boxes. */
    void forget() {
        known = false;
    }

    /** Whether an event may lie on the contour of the k-th plane. */
    boolean hold(int k, long event) {
        return holds(boxes[k], event);
    }

    /** Whether an event lies in a box. */
    static boolean holds(long box, long event) {
        return (event - box & HIGHEST_BITS) == HIGHEST_BITS;
    }
}
