package io.github.sofas.recording;

import static io.github.sofas.recording.EvtFormat.COORDINATE_MASK;
import static io.github.sofas.recording.EvtFormat.INT;
import static io.github.sofas.recording.EvtFormat.ON_2;
import static io.github.sofas.recording.EvtFormat.TIME_HIGH;
import static io.github.sofas.recording.EvtFormat.TIME_HIGH_MASK_2;
import static io.github.sofas.recording.EvtFormat.TIME_LOW_BITS_2;
import static io.github.sofas.recording.EvtFormat.TIME_MASK_2;
import static io.github.sofas.recording.EvtFormat.TIME_RANGE_BITS_2;
import static io.github.sofas.recording.EvtFormat.TIME_SHIFT_2;
import static io.github.sofas.recording.EvtFormat.TRIGGER;
import static io.github.sofas.recording.EvtFormat.TYPE_SHIFT_2;
import static io.github.sofas.recording.EvtFormat.WRAP_STEP_US_2;
import static io.github.sofas.recording.EvtFormat.X_SHIFT_2;

import io.github.sofas.event.EventBatch;

/** Reads EVT 2.0: each event is one word of 32 bits; other words give the high bits of time. */
final class Evt2Reader extends EvtReader {
    Evt2Reader(RecordingFile file, RecordingOptions options, ChipChoice choice) {
        super(file, options, "EVT 2.0", choice, Integer.BYTES, TIME_RANGE_BITS_2, WRAP_STEP_US_2);
    }

    @Override
    int typeAt(int p) {
        return (int) INT.get(file.buffer, p) >>> TYPE_SHIFT_2;
    }

    @Override
    void decodeWords(EventBatch batch, int already) throws MalformedRecordingException {
        byte[] buffer = file.buffer;
        int lastWord = file.limit - Integer.BYTES;
        int p = file.position;
        int capacity = batch.capacity();
        int width = sensor().width();
        int height = sensor().height();
        int n = already;
        try {
            for (; p <= lastWord && n < capacity; p += Integer.BYTES) {
                int word = (int) INT.get(buffer, p);
                int type = word >>> TYPE_SHIFT_2;
                if (type > ON_2) {
                    otherWord(type, word);
                    continue;
                }
                int column = word >>> X_SHIFT_2 & COORDINATE_MASK;
                int row = word & COORDINATE_MASK;
                if (column >= width || row >= height) {
                    outside(column, row, eventNumber(n), offsetOf(p));
                    continue;
                }
                note(n, offsetOf(p));
                batch.timeUs[n] = highUs + (word >>> TIME_SHIFT_2 & TIME_MASK_2);
                batch.x[n] = (short) column;
                batch.y[n] = (short) row;
                batch.polarity[n] = (byte) (2 * type - 1);
                n++;
            }
        } finally {
            file.position = p;
            deliver(batch, n);
        }
    }

    private void otherWord(int type, int word) {
        if (type == TIME_HIGH) {
            timeHigh((long) (word & TIME_HIGH_MASK_2) << TIME_LOW_BITS_2);
        } else if (type == TRIGGER) {
            triggers++;
        } else {
            otherRecords++;
        }
    }
}
