package io.github.sofas.flow.search;

/** Events numbered in the order in which they came, of which only the newest are held. */
interface NumberedEvents {
    /** Number of the oldest event that is held. */
    int oldest();

    /** Number after the newest event. */
    int head();

    /** Time of an event that is held, in µs. */
    long timeUs(int event);

    /** Number of the oldest held event that is not before a time; {@link #head()} where there is none. */
    default int first(long fromUs) {
        int low = oldest();
        int count = head() - low;
        while (count > 0) {
            int half = count / 2;
            if (timeUs(low + half) < fromUs) {
                low += half + 1;
                count -= half + 1;
            } else {
                count = half;
            }
        }
        return low;
    }
}
