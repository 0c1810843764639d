package io.github.sofas.recording;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSourceException;
import java.io.IOException;
import java.nio.charset.StandardCharsets;

/**
 * Reads Event Stream 2 ({@code .es}) with DVS events. The header holds the words "Event Stream", three bytes of
 * version, one byte of type, and width and height in two little-endian bytes each. Each event has a byte with the
 * polarity (lowest bit) and the time since the event before it in µs, then x and y in two bytes each. A byte 0xFF adds
 * 127 µs; 0xFE is a reset without effect. x runs right, y up. Holds one file buffer.
 *
 * <p>Source: the published description (neuromorphic-paris/event_stream).
 */
final class EventStreamReader extends RecordingReader {
    static final byte[] MAGIC = "Event Stream".getBytes(StandardCharsets.US_ASCII);

    private static final int VERSION_AT = 12;
    private static final int TYPE_AT = 15;
    private static final int WIDTH_AT = 16;
    private static final int HEIGHT_AT = 18;
    private static final int HEADER_BYTES = 20;
    private static final int VERSION = 2;
    private static final int DVS = 1;
    private static final String[] TYPES = {"generic", "DVS", "ATIS", "ATIS", "colour"};

    private static final int EVENT_BYTES = 5;
    private static final int LATER = 0xFF;
    private static final int LATER_US = 127;
    private static final int RESET = 0xFE;

    private long timeUs;

    private EventStreamReader(RecordingFile file, RecordingOptions options, ChipChoice choice) {
        super(file, options, "Event Stream " + VERSION, choice.name(), choice.sensor());
    }

    /** Reads the header and makes a reader at the first event. */
    static EventStreamReader open(RecordingFile file, RecordingOptions options)
            throws IOException, EventSourceException {
        String place = "[" + file.name + "] header at byte ";
        if (!file.require(HEADER_BYTES)) {
            throw new MalformedRecordingException(place + "0: truncated, the header must have " + HEADER_BYTES
                    + " bytes but had " + file.available());
        }
        int at = file.position;
        int version = file.buffer[at + VERSION_AT] & 0xFF;
        if (version != VERSION) {
            throw new MalformedRecordingException(place + VERSION_AT + ": unsupported, the version must be " + VERSION
                    + " but was " + version);
        }
        int type = file.buffer[at + TYPE_AT] & 0xFF;
        if (type != DVS) {
            throw new MalformedRecordingException(place + TYPE_AT + ": unsupported, the events must be of type " + DVS
                    + " (DVS) but were of type " + type + (type < TYPES.length ? " (" + TYPES[type] + ")" : ""));
        }
        ChipChoice choice = ChipChoice.withOwnSize(file.name, WIDTH_AT, null, number(file, at + WIDTH_AT),
                number(file, at + HEIGHT_AT), options);
        file.position += HEADER_BYTES;
        RecordingReader reader = new EventStreamReader(file, options, choice);
        choice.reportTo(reader);
        return (EventStreamReader) reader;
    }

    private static String number(RecordingFile file, int p) {
        return String.valueOf(file.buffer[p] & 0xFF | (file.buffer[p + 1] & 0xFF) << Byte.SIZE);
    }

    @Override
    boolean decode(EventBatch batch) throws IOException, MalformedRecordingException {
        if (!file.require(EVENT_BYTES) && file.available() == 0) {
            return false;
        }
        byte[] buffer = file.buffer;
        int limit = file.limit;
        int p = file.position;
        int capacity = batch.capacity();
        int width = sensor().width();
        int height = sensor().height();
        int n = 0;
        long time = timeUs;
        try {
            while (p < limit && n < capacity) {
                int head = buffer[p] & 0xFF;
                if (head >= RESET) {
                    time += head == LATER ? LATER_US : 0;
                    otherRecords += head == RESET ? 1 : 0;
                    p++;
                    continue;
                }
                if (p + EVENT_BYTES > limit) {
                    break;
                }
                time += head >>> 1;
                int column = buffer[p + 1] & 0xFF | (buffer[p + 2] & 0xFF) << Byte.SIZE;
                int up = buffer[p + 3] & 0xFF | (buffer[p + 4] & 0xFF) << Byte.SIZE;
                p += EVENT_BYTES;
                if (column >= width || up >= height) {
                    outside(column, up, eventNumber(n), offsetOf(p - EVENT_BYTES));
                    continue;
                }
                note(n, offsetOf(p - EVENT_BYTES));
                batch.timeUs[n] = time;
                batch.x[n] = (short) column;
                batch.y[n] = (short) (height - 1 - up);
                batch.polarity[n] = (byte) (2 * (head & 1) - 1);
                n++;
            }
        } finally {
            timeUs = time;
            file.position = p;
            deliver(batch, n);
        }
        if (p < limit && n < capacity && !file.require(EVENT_BYTES)) {
            throw malformed(eventNumber(0), file.offset(), "truncated, an event must have " + EVENT_BYTES
                    + " bytes but had " + file.available());
        }
        return true;
    }
}
