package io.github.sofas.flow.smooth;

/**
 * Selects some squares of a picture by chance, where there are too many events. Whole squares are taken, because
 * thinning single events thins their meetings by the square.
 */
final class Squares {
    /** Side of a square in px, as a power of two. */
    private static final int SIDE_BITS = 3;
    /** The share that takes all squares. */
    private static final long ALL = 1L << Integer.SIZE;

    private Squares() {
    }

    /** Number of squares to take out of 2^32, so that about as many events are left as are wanted. */
    static long share(int events, double wanted) {
        return events <= wanted ? ALL : (long) (wanted / events * ALL);
    }

    /** Whether the square with a place in px is taken; the choice of squares changes with the time. */
    static boolean isTaken(double x, double y, long us, long share) {
        if (share == ALL) {
            return true;
        }
        long column = (long) Math.floor(x) >> SIDE_BITS;
        long row = (long) Math.floor(y) >> SIDE_BITS;
        long hash = (column * 0x9E3779B97F4A7C15L ^ row * 0xC2B2AE3D27D4EB4FL ^ us * 0x165667B19E3779F9L)
            * 0x9E3779B97F4A7C15L;
        return hash >>> Integer.SIZE < share;
    }
}
