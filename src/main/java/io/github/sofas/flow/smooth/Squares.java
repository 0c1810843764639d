package io.github.sofas.flow.smooth;

/**
 * Squares of a picture of which some are taken by chance, where there are too many events: whole squares, because
 * thinning events one by one thins their meetings by the square.
 */
final class Squares {
    /** Side of a square in px, as a power of two. */
    private static final int SIDE_BITS = 3;
    /** Share of all squares. */
    private static final long ALL = 1L << Integer.SIZE;

    private Squares() {
    }

    /** How many of 2^32 squares are to be taken, so that of some events about as many are left as are wanted. */
    static long share(int events, double wanted) {
        return events <= wanted ? ALL : (long) (wanted / events * ALL);
    }

    /** Whether the square is taken that a place in px is on; at another time it is others. */
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
