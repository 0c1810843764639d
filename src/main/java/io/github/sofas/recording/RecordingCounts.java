package io.github.sofas.recording;

/**
 * Numbers of all that a reader has met so far, by kind. Only the {@link #events()} were delivered.
 *
 * @param events change events (DVS) delivered
 * @param apsSamples samples of the intensity pixels (AEDAT 2: one per pixel and read)
 * @param frames whole frames (AEDAT 3 and 4)
 * @param imuSamples whole samples of the inertial sensor
 * @param triggers special and external events
 * @param invalid events that the recorder marked as invalid; not delivered
 * @param outsideSensor events whose pixel lies outside the sensor; not delivered
 * @param stepsBack events delivered with a later time than their own, because time had stepped back
 * @param timeWraps overflows of the recording's time that were undone
 * @param otherRecords records or packets of unsupported kinds; skipped
 * @param malformed records with bits that no recorder sets, which are delivered as their other bits say, and words of
 *     inertial samples that are out of order
 * @param damagedTimes events whose time is far from that of all events around them; not delivered
 * @param timeRestarts how often the clock was set back; time then continues from the greatest time before
 */
public record RecordingCounts(long events, long apsSamples, long frames, long imuSamples, long triggers, long invalid,
                              long outsideSensor, long stepsBack, long timeWraps, long otherRecords,
                              long malformed, long damagedTimes, long timeRestarts) {

    /**
     * {@return the share of the events that were corrected or dropped, 0 to 1} These events were dropped because of
     * their pixel or time, or delivered with another time or only a part of their address. Events that the recorder
     * marked as invalid do not count, because the recorder meant to drop them.
     */
    public double doubtfulShare() {
        long dropped = outsideSensor + damagedTimes;
        long all = events + dropped;
        return all == 0 ? 0 : (double) (dropped + stepsBack + malformed) / all;
    }
}
