package io.github.sofas.recording;

/**
 * Times of a recording that are out of order, as {@link TimeOrder} finds them: told and counted, or the end of the
 * reading where that is strict.
 */
final class TimeFaults {
    /** Where a larger share of the events is out of order, it is not some that are damaged. */
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

    /** Counts an event whose time is below one before it, and which gets the time of that. */
    void stepBack(long timeUs, long event, long offset) throws MalformedRecordingException {
        outOfOrder("time", event, offset, rule(timeUs), "");
        stepsBack++;
    }

    /** Counts an event whose time is damaged, and which is not delivered. */
    void damaged(long timeUs, long event, long offset) throws MalformedRecordingException {
        outOfOrder("jump", event, offset, "malformed, time must go on from " + reader.lastTimeUs() + " us but was "
                + timeUs + " us", ", from which the next events do not go on; the event was dropped");
        damagedTimes++;
    }

    /** Counts that the clock started again; time goes on from the greatest before. */
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
     * What is wrong where too many events are out of order for some damage; null where they are not.
     *
     * @param decoded how many events there were
     */
    String disorder(long decoded) {
        long outOfOrder = stepsBack + damagedTimes;
        return decoded < FEWEST_FOR_ORDER || outOfOrder <= decoded * MOST_OUT_OF_ORDER ? null
            : "malformed, events must be in order of time but " + outOfOrder + " of " + decoded + " were not";
    }

    /** Events that got the time of one before. */
    long stepsBack() {
        return stepsBack;
    }

    /** Events that were dropped. */
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
