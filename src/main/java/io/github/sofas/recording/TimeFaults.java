package io.github.sofas.recording;

/**
 * Reports and counts the times of a recording that are out of order, as {@link TimeOrder} finds them. Where the reading
 * is strict, the first of them ends it.
 */
final class TimeFaults {
    /** A larger share of events out of order cannot be explained by some damaged events. */
    private static final double MOST_OUT_OF_ORDER = 0.1;
    private static final int FEWEST_FOR_ORDER = 100;

    private final RecordingReader reader;
    private final boolean strict;
    private long stepsBack;
    private long damagedTimes;
    private long restarts;
    private long wraps;

    TimeFaults(RecordingReader reader, boolean strict) {
        this.reader = reader;
        this.strict = strict;
    }

    /** Counts an event whose time is below that of an earlier event, and which gets that event's time. */
    void stepBack(long timeUs, long event, long offset) throws MalformedRecordingException {
        outOfOrder("time", event, offset, rule(timeUs), "");
        stepsBack++;
    }

    /** Counts an event whose time is damaged; the event is not delivered. */
    void damaged(long timeUs, long event, long offset) throws MalformedRecordingException {
        outOfOrder("jump", event, offset, "malformed, time must go on from " + reader.lastTimeUs() + " us but was "
                + timeUs + " us", ", from which the next events do not go on; the event was dropped");
        damagedTimes++;
    }

    /** Counts a restart of the clock; time continues from the greatest time before. */
    void restarts(long timeUs, long event, long offset) throws MalformedRecordingException {
        outOfOrder("restart", event, offset, rule(timeUs), ", from where it goes on; "
                + (reader.lastTimeUs() - timeUs) + " us were added from there on");
        restarts++;
    }

    /** Counts an overflow of the clock, which is no fault. */
    void wrapped() {
        wraps++;
    }

    private void outOfOrder(String kind, long event, long offset, String rule, String consequence)
            throws MalformedRecordingException {
        if (strict) {
            throw reader.malformed(event, offset, (rule.startsWith("malformed") ? "" : "malformed, ") + rule);
        }
        reader.addFault(kind, () -> reader.at(event, offset) + rule + consequence);
    }

    private String rule(long timeUs) {
        return "time must not fall below " + reader.lastTimeUs() + " us but was " + timeUs + " us";
    }

    /**
     * The fault of a recording with more events out of order than some damage explains; null where there are few.
     *
     * @param decoded number of events decoded
     */
    String disorder(long decoded) {
        long outOfOrder = stepsBack + damagedTimes;
        return decoded < FEWEST_FOR_ORDER || outOfOrder <= decoded * MOST_OUT_OF_ORDER ? null
            : "malformed, events must be in order of time but " + outOfOrder + " of " + decoded + " were not";
    }

    /** Number of events that got the time of an earlier one. */
    long stepsBack() {
        return stepsBack;
    }

    /** Number of events that were dropped. */
    long damagedTimes() {
        return damagedTimes;
    }

    /** How often the clock started again. */
    long restarts() {
        return restarts;
    }

    /** How many overflows of the clock there were. */
    long wraps() {
        return wraps;
    }
}
