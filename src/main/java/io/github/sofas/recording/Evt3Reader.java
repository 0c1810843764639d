package io.github.sofas.recording;

import static io.github.sofas.recording.EvtFormat.COLUMN_3;
import static io.github.sofas.recording.EvtFormat.COORDINATE_MASK;
import static io.github.sofas.recording.EvtFormat.ON_3;
import static io.github.sofas.recording.EvtFormat.PAYLOAD_MASK_3;
import static io.github.sofas.recording.EvtFormat.ROW_3;
import static io.github.sofas.recording.EvtFormat.SHORT;
import static io.github.sofas.recording.EvtFormat.TIME_BITS_3;
import static io.github.sofas.recording.EvtFormat.TIME_HIGH;
import static io.github.sofas.recording.EvtFormat.TIME_LOW_3;
import static io.github.sofas.recording.EvtFormat.TRIGGER;
import static io.github.sofas.recording.EvtFormat.TYPE_SHIFT_3;
import static io.github.sofas.recording.EvtFormat.VECTOR_12_3;
import static io.github.sofas.recording.EvtFormat.VECTOR_12_BITS;
import static io.github.sofas.recording.EvtFormat.VECTOR_8_3;
import static io.github.sofas.recording.EvtFormat.VECTOR_8_BITS;
import static io.github.sofas.recording.EvtFormat.VECTOR_BASE_3;

import io.github.sofas.event.EventBatch;

/**
 * Reads EVT 3.0: words of 16 bits, each of which changes one part of the reader's state. An event is a word with a
 * column, at the row and time of the words before it. A vector word marks the events among 8 or 12 pixels from a base
 * column on, and moves the base to the right by that number.
 */
final class Evt3Reader extends EvtReader {
    private static final int NO_ROW = -1;
    /** Half of the range, because the high bits come every 16 µs. */
    private static final long WRAP_STEP_US = 1L << 2 * TIME_BITS_3 - 1;

    private int row = NO_ROW;
    private int baseX;
    private int basePolarity;
    private long timeUs;

    Evt3Reader(RecordingFile file, RecordingOptions options, ChipChoice choice) {
        super(file, options, "EVT 3.0", choice, Short.BYTES, 2 * TIME_BITS_3, WRAP_STEP_US);
    }

    @Override
    int typeAt(int p) {
        return ((short) SHORT.get(file.buffer, p) & 0xFFFF) >>> TYPE_SHIFT_3;
    }

    @Override
    void decodeWords(EventBatch batch, int already) throws MalformedRecordingException {
        byte[] buffer = file.buffer;
        int lastWord = file.limit - Short.BYTES;
        int p = file.position;
        int capacity = batch.capacity();
        int width = sensor().width();
        int height = sensor().height();
        int y = row;
        long time = timeUs;
        int n = already;
        try {
            for (; p <= lastWord && n < capacity; p += Short.BYTES) {
                int word = (short) SHORT.get(buffer, p) & 0xFFFF;
                switch (word >>> TYPE_SHIFT_3) {
                    case COLUMN_3:
                        int column = word & COORDINATE_MASK;
                        if (column >= width || y >= height || y < 0) {
                            notOnSensor(column, y, n, p);
                            break;
                        }
                        note(n, offsetOf(p));
                        batch.timeUs[n] = time;
                        batch.x[n] = (short) column;
                        batch.y[n] = (short) y;
                        batch.polarity[n] = (byte) ((word & ON_3) == 0 ? -1 : 1);
                        n++;
                        break;
                    case ROW_3:
                        y = word & COORDINATE_MASK;
                        break;
                    case TIME_LOW_3:
                        time = highUs + (word & PAYLOAD_MASK_3);
                        break;
                    case TIME_HIGH:
                        long before = highUs;
                        timeHigh((long) (word & PAYLOAD_MASK_3) << TIME_BITS_3);
                        if (highUs != before) {
                            time = highUs;
                        }
                        break;
                    case VECTOR_BASE_3:
                        baseX = word & COORDINATE_MASK;
                        basePolarity = (word & ON_3) == 0 ? -1 : 1;
                        break;
                    case VECTOR_12_3:
                        n = vector(word, VECTOR_12_BITS, y, time, batch, n, p);
                        break;
                    case VECTOR_8_3:
                        n = vector(word, VECTOR_8_BITS, y, time, batch, n, p);
                        break;
                    case TRIGGER:
                        triggers++;
                        break;
                    default:
                        otherRecords++;
                        break;
                }
            }
        } finally {
            row = y;
            timeUs = time;
            file.position = p;
            deliver(batch, n);
        }
    }

    private int vector(int word, int bits, int y, long time, EventBatch batch, int n, int p)
            throws MalformedRecordingException {
        int mask = word & (1 << bits) - 1;
        vectorX = baseX;
        baseX += bits;
        if (y == NO_ROW || basePolarity == 0) {
            for (int i = Integer.bitCount(mask); i > 0; i--) {
                notOnSensor(vectorX, y, n, p);
            }
            return n;
        }
        vectorMask = mask;
        vectorY = y;
        vectorPolarity = basePolarity;
        vectorUs = time;
        return emit(batch, n, p);
    }

    /** Counts an event whose pixel is unknown or outside the sensor. */
    private void notOnSensor(int column, int y, int n, int p) {
        if (y != NO_ROW && (column >= sensor().width() || y >= sensor().height())) {
            outside(column, y, eventNumber(n), offsetOf(p));
            return;
        }
        long event = eventNumber(n);
        invalid++;
        addFault("place", () -> at(event, offsetOf(p)) + "malformed, an event's row and a vector's base must come "
                + "before it; it was passed over");
    }
}
