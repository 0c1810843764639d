/**
 * Recordings of event cameras: AEDAT 1.0, 2.0, 3.x, 4.0, Prophesee's RAW (EVT) and DAT, HDF5, Event Stream, N-MNIST and
 * text. Start with {@link io.github.sofas.recording.Recordings}, which detects the format and makes the reader. Each
 * format has a class {@code XReader}, and a class {@code XFormat} for its constants where there are many. What all
 * readers share (order of time, counts, faults) is in {@link io.github.sofas.recording.RecordingReader}.
 *
 * <p>The package depends on {@code event} only. Memory: every reader holds one buffer of 128 KiB, whatever the size of
 * the file. A reader of AEDAT 4 also holds one packet, packed and unpacked: a few MiB as recorders write them, at most
 * 128 MiB each. A reader of HDF5 also holds one chunk of each column: about 100 kB as recorders write them, at most 128
 * MiB each.
 */
package io.github.sofas.recording;
