package io.github.sofas.recording;

/**
 * What a reader has met so far, by kind. Only {@link #events()} were delivered.
 *
 * @param events change events (DVS) delivered
 * @param apsSamples samples of the intensity pixels (AEDAT 2: one a pixel and read)
 * @param frames whole frames (AEDAT 3 and 4)
 * @param imuSamples whole samples of the inertial sensor
 * @param triggers special and external events
 * @param invalid events that the recorder marked as invalid; not delivered
 * @param outsideSensor events whose pixel lies outside the sensor; not delivered
 * @param stepsBack events delivered with a later time than their own, because time had stepped back
 * @param timeWraps overflows of 32-bit time that were undone
 * @param otherRecords records or packets of kinds that are not served; passed over
 */
public record RecordingCounts(long events, long apsSamples, long frames, long imuSamples, long triggers, long invalid,
                              long outsideSensor, long stepsBack, long timeWraps, long otherRecords) {
}
