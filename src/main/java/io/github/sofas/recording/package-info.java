/**
 * Recordings of event cameras: AEDAT 1.0, 2.0, 3.x, 4.0 and text. Open {@link io.github.sofas.recording.Recordings}
 * first: it tells the formats apart and makes the reader. Each format is a class {@code XFormat} with its constants and
 * a class {@code XReader}; what all readers share (order of time, counts, faults) is in
 * {@link io.github.sofas.recording.RecordingReader}.
 *
 * <p>Depends on {@code event} only. A reader holds one buffer of 128 KiB and, for AEDAT 4, one packet packed and
 * unpacked; how much is had at most is written in each reader.
 */
package io.github.sofas.recording;
