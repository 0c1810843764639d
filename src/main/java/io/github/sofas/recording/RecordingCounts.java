package io.github.sofas.recording;

/**
 * What a reader has met so far, by kind. Only {@link #events()} were delivered.
 *
 * @param events change events (DVS) delivered
 * @param apsSamples samples of the intensity pixels (AEDAT 2: one per pixel and read)
 * @param frames whole frames (AEDAT 3 and 4)
 * @param imuSamples whole samples of the inertial sensor
 * @param triggers special and external events
 * @param invalid events that the recorder marked as invalid; not delivered
 * @param outsideSensor events whose pixel lies outside the sensor; not delivered
 * @param stepsBack events delivered with a later time than their own, because time had stepped back
 * @param timeWraps overflows of 32-bit time that were undone
 * @param otherRecords records or packets of kinds that are not served; passed over
 * @param malformed records with bits that no recorder sets; delivered as what else they say
 * @param damagedTimes events whose time is far from that of all events around them; not delivered
 * @param timeRestarts how often the clock was set back; time then goes on from the greatest before
 */
public record RecordingCounts(long events, long apsSamples, long frames, long imuSamples, long triggers, long invalid,
                              long outsideSensor, long stepsBack, long timeWraps, long otherRecords,
                              long malformed, long damagedTimes, long timeRestarts) {

    /**
     * {@return the share of the events that were corrected or dropped, 0 to 1} That is: dropped because of their pixel
     * or time, or delivered with another time or only a part of their address. Events that the recorder marked as
     * invalid are not among them, for that was meant.
     */
    public double doubtfulShare() {
        long dropped = outsideSensor + damagedTimes;
        long all = events + dropped;
        return all == 0 ? 0 : (double) (dropped + stepsBack + malformed) / all;
    }
}
