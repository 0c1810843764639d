package io.github.sofas.recording;

import io.github.sofas.event.EventBatch;
import java.io.IOException;

/**
 * Reads the {@code .bin} files of N-MNIST and N-Caltech101. An event has five bytes, big-endian: x, y, the polarity in
 * the highest bit of the third byte, and the time in µs in the other 23 bits. x runs right, y down. An event in row 240
 * is no real event: it adds 8,192 µs to all later times. Nothing in these files marks their format, so the extension
 * decides. Holds one file buffer.
 *
 * <p>Source: the data sets' own {@code Read_Ndataset} (Orchard et al. 2015, "Converting static image datasets to
 * spiking neuromorphic datasets using saccades").
 */
final class NMnistReader extends RecordingReader {
    static final String EXTENSION = ".bin";

    private static final int EVENT_BYTES = 5;
    private static final int OVERFLOW_ROW = 240;
    private static final int OVERFLOW_US = 1 << 13;
    private static final int TIME_HIGH_MASK = 0x7F;

    private long overflowUs;

    NMnistReader(RecordingFile file, RecordingOptions options, ChipChoice choice) {
        super(file, options, "N-MNIST", choice.name(), choice.sensor());
    }

    @Override
    boolean decode(EventBatch batch) throws IOException, MalformedRecordingException {
        if (!file.require(EVENT_BYTES)) {
            if (file.available() > 0) {
                throw malformed(eventNumber(0), file.offset(), "truncated, an event must have " + EVENT_BYTES
                        + " bytes but had " + file.available());
            }
            return false;
        }
        byte[] buffer = file.buffer;
        int lastEvent = file.limit - EVENT_BYTES;
        int p = file.position;
        int n = 0;
        try {
            for (; p <= lastEvent && n < batch.capacity(); p += EVENT_BYTES) {
                int column = buffer[p] & 0xFF;
                int row = buffer[p + 1] & 0xFF;
                if (row == OVERFLOW_ROW) {
                    overflowUs += OVERFLOW_US;
                    timeWrapped();
                    continue;
                }
                if (!sensor().contains(column, row)) {
                    outside(column, row, eventNumber(n), offsetOf(p));
                    continue;
                }
                int high = buffer[p + 2];
                long time = overflowUs + ((high & TIME_HIGH_MASK) << 16 | (buffer[p + 3] & 0xFF) << 8
                        | buffer[p + 4] & 0xFF);
                note(n, offsetOf(p));
                batch.timeUs[n] = time;
                batch.x[n] = (short) column;
                batch.y[n] = (short) row;
                batch.polarity[n] = (byte) (high < 0 ? 1 : -1);
                n++;
            }
        } finally {
            file.position = p;
            deliver(batch, n);
        }
        return true;
    }
}
