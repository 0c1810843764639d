/**
 * Recordings of event cameras: AEDAT 1.0, 2.0, 3.x, 4.0, Prophesee's RAW (EVT) and DAT, HDF5, Event Stream, N-MNIST and
 * text. Open {@link io.github.sofas.recording.Recordings} first: it detects the format and makes the reader. Each
 * format is a class {@code XReader}, and a class {@code XFormat} with its constants where there are many; what all
 * readers share (order of time, counts, faults) is in {@link io.github.sofas.recording.RecordingReader}.
 *
 * <p>Depends on {@code event} only. Memory: a reader holds one buffer of 128 KiB, whatever the file's size, and for
 * AEDAT 4 also one packet packed and unpacked (a few MiB as recorders write them, 128 MiB each at most), for HDF5 a
 * chunk of each column (some 100 kB as recorders write them, 128 MiB each at most).
 */
package io.github.sofas.recording;
