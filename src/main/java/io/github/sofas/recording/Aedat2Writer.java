package io.github.sofas.recording;

import static io.github.sofas.recording.Aedat2Format.CHIP_LINE;
import static io.github.sofas.recording.Aedat2Format.DAVIS_ON_SHIFT;
import static io.github.sofas.recording.Aedat2Format.DAVIS_X_SHIFT;
import static io.github.sofas.recording.Aedat2Format.DAVIS_Y_SHIFT;
import static io.github.sofas.recording.Aedat2Format.DVS128_OFF;
import static io.github.sofas.recording.Aedat2Format.DVS128_X_SHIFT;
import static io.github.sofas.recording.Aedat2Format.DVS128_Y_SHIFT;
import static io.github.sofas.recording.Aedat2Format.END_LINE;
import static io.github.sofas.recording.Aedat2Format.INT;
import static io.github.sofas.recording.Aedat2Format.RECORD_BYTES_2;

import io.github.sofas.event.EventBatch;
import java.io.BufferedOutputStream;
import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * Writes change events as AEDAT 2.0, which jAER and most tools read.
 *
 * <p>The file is complete only after {@link #close()} has returned. Times are written in 32 bits and overflow as those
 * of jAER do. A reader that undoes overflows restores the times up to a multiple of 2^32 µs, which is zero where the
 * first time fits into 32 bits. This holds as long as no two successive events lie more than 2^31 µs apart.
 */
public final class Aedat2Writer implements Closeable {
    private static final String HEADER = "#!AER-DAT2.0\r\n"
            + "# This is a raw AE data file - do not edit\r\n"
            + "# Data format is int32 address, int32 timestamp (8 bytes total), repeated for each event\r\n"
            + "# Timestamps tick is 1 us\r\n";
    private static final int RECORDS_BUFFERED = 4096;

    private final OutputStream out;
    private final Chip chip;
    private final byte[] buffer = new byte[RECORDS_BUFFERED * RECORD_BYTES_2];
    private final int headerBytes;
    private long lastTimeUs = Long.MIN_VALUE;
    private long events;

    /**
     * Creates or replaces the file and writes the header.
     *
     * @param path file that gets the recording; replaced where it exists
     * @param chip chip that the events come from
     * @throws IOException where the file cannot be written
     */
    public Aedat2Writer(Path path, Chip chip) throws IOException {
        this(Files.newOutputStream(path), chip);
    }

    /**
     * Writes the header to a stream, which {@link #close()} closes.
     *
     * @param stream gets the recording; closed with the writer
     * @param chip chip that the events come from
     * @throws IOException where the stream cannot be written
     */
    public Aedat2Writer(OutputStream stream, Chip chip) throws IOException {
        this.chip = chip;
        out = new BufferedOutputStream(stream);
        String header = HEADER + CHIP_LINE + chip.className() + "\r\n" + END_LINE + "\r\n";
        headerBytes = header.length();
        out.write(header.getBytes(StandardCharsets.US_ASCII));
    }

    /**
     * Appends the events of a batch.
     *
     * @param batch the events
     * @throws IllegalArgumentException where an event lies outside the chip's sensor, or before the preceding event in
     *     time; the events before the offending one are written
     * @throws IOException where the file cannot be written
     */
    public void write(EventBatch batch) throws IOException {
        int p = 0;
        for (int i = 0; i < batch.size(); i++) {
            if (p == buffer.length) {
                out.write(buffer, 0, p);
                p = 0;
            }
            String broken = brokenRule(batch, i);
            if (broken != null) {
                out.write(buffer, 0, p);
                throw new IllegalArgumentException("event " + events + ": " + broken);
            }
            lastTimeUs = batch.timeUs[i];
            INT.set(buffer, p, address(batch.x[i], batch.y[i], batch.polarity[i]));
            INT.set(buffer, p + Integer.BYTES, (int) lastTimeUs);
            p += RECORD_BYTES_2;
            events++;
        }
        out.write(buffer, 0, p);
    }

    private String brokenRule(EventBatch batch, int i) {
        String outside = chip.sensor().brokenRule(batch.x[i], batch.y[i]);
        if (outside != null) {
            return outside;
        }
        return batch.timeUs[i] >= lastTimeUs ? null
                : "time must not fall below " + lastTimeUs + " us but was " + batch.timeUs[i] + " us";
    }

    private int address(int x, int y, int polarity) {
        int rawX = chip.sensor().width() - 1 - x;
        int rawY = chip.sensor().height() - 1 - y;
        if (chip.layout() == Chip.AddressLayout.DVS128) {
            return rawX << DVS128_X_SHIFT | rawY << DVS128_Y_SHIFT | (polarity > 0 ? 0 : DVS128_OFF);
        }
        return rawX << DAVIS_X_SHIFT | rawY << DAVIS_Y_SHIFT | (polarity > 0 ? 1 : 0) << DAVIS_ON_SHIFT;
    }

    /**
     * Writes all buffered data, which consists of whole records.
     *
     * @throws IOException where the data cannot be written
     */
    public void flush() throws IOException {
        out.flush();
    }

    /**
     * {@return the length of the header and the whole records of a file that could not be written to its end}
     *
     * @param bytes length of the file, in bytes
     */
    public long wholeBytes(long bytes) {
        return Math.max(headerBytes, bytes - (bytes - headerBytes) % RECORD_BYTES_2);
    }

    /** Writes all buffered data and closes the file. */
    @Override
    public void close() throws IOException {
        out.close();
    }
}
