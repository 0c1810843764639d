package io.github.sofas.recording;

import static io.github.sofas.recording.EvtFormat.COORDINATE_MASK;
import static io.github.sofas.recording.EvtFormat.LONG;
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

/**
 * Reads EVT 2.1: words of 64 bits. The upper half has the fields of a word of EVT 2.0. The lower half marks which of
 * the 32 pixels from that position to the right have an event.
 */
final class Evt21Reader extends EvtReader {
    /** Number of bits by which a word is rotated, so that its type is in the highest bits. */
    private final int turn;

    Evt21Reader(RecordingFile file, RecordingOptions options, boolean isLegacy, ChipChoice choice) {
        super(file, options, "EVT 2.1", choice, Long.BYTES, TIME_RANGE_BITS_2, WRAP_STEP_US_2);
        turn = isLegacy ? Integer.SIZE : 0;
    }

    @Override
    int typeAt(int p) {
        return (int) (Long.rotateLeft((long) LONG.get(file.buffer, p), turn) >>> Integer.SIZE + TYPE_SHIFT_2);
    }

    @Override
    void decodeWords(EventBatch batch, int already) throws MalformedRecordingException {
        int lastWord = file.limit - Long.BYTES;
        int p = file.position;
        int n = already;
        try {
            for (; p <= lastWord && n < batch.capacity(); p += Long.BYTES) {
                long word = Long.rotateLeft((long) LONG.get(file.buffer, p), turn);
                int head = (int) (word >>> Integer.SIZE);
                int type = head >>> TYPE_SHIFT_2;
                if (type <= ON_2) {
                    vectorMask = (int) word;
                    vectorX = head >>> X_SHIFT_2 & COORDINATE_MASK;
                    vectorY = head & COORDINATE_MASK;
                    vectorPolarity = 2 * type - 1;
                    vectorUs = highUs + (head >>> TIME_SHIFT_2 & TIME_MASK_2);
                    n = emit(batch, n, p);
                } else if (type == TIME_HIGH) {
                    timeHigh((long) (head & TIME_HIGH_MASK_2) << TIME_LOW_BITS_2);
                } else if (type == TRIGGER) {
                    triggers++;
                } else {
                    otherRecords++;
                }
            }
        } finally {
            file.position = p;
            deliver(batch, n);
        }
    }
}
