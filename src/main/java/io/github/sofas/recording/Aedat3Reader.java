package io.github.sofas.recording;

import static io.github.sofas.recording.Aedat3Format.EVENT_BYTES_AT;
import static io.github.sofas.recording.Aedat3Format.FRAME;
import static io.github.sofas.recording.Aedat3Format.IMU6;
import static io.github.sofas.recording.Aedat3Format.IMU9;
import static io.github.sofas.recording.Aedat3Format.INT;
import static io.github.sofas.recording.Aedat3Format.MASK_30;
import static io.github.sofas.recording.Aedat3Format.MASK_31;
import static io.github.sofas.recording.Aedat3Format.NUMBER_AT;
import static io.github.sofas.recording.Aedat3Format.ON_SHIFT;
import static io.github.sofas.recording.Aedat3Format.PACKET_HEADER_BYTES;
import static io.github.sofas.recording.Aedat3Format.POLARITY;
import static io.github.sofas.recording.Aedat3Format.POLARITY_BYTES;
import static io.github.sofas.recording.Aedat3Format.SHORT;
import static io.github.sofas.recording.Aedat3Format.SOURCE_AT;
import static io.github.sofas.recording.Aedat3Format.SPECIAL;
import static io.github.sofas.recording.Aedat3Format.TIME_BITS;
import static io.github.sofas.recording.Aedat3Format.TIME_OVERFLOW_AT;
import static io.github.sofas.recording.Aedat3Format.TIME_PLACE_AT;
import static io.github.sofas.recording.Aedat3Format.VALID;
import static io.github.sofas.recording.Aedat3Format.X_SHIFT_30;
import static io.github.sofas.recording.Aedat3Format.X_SHIFT_31;
import static io.github.sofas.recording.Aedat3Format.Y_SHIFT_30;
import static io.github.sofas.recording.Aedat3Format.Y_SHIFT_31;

import io.github.sofas.event.EventBatch;
import java.io.IOException;

/**
 * Reads AEDAT 3.0 and 3.1. Holds one file buffer: packets are decoded as they come and never held whole. Where the
 * header declares several sources, only events of the first one are delivered.
 */
final class Aedat3Reader extends RecordingReader {
    private static final int ANY_SOURCE = -1;

    private final int source;
    private final int xShift;
    private final int yShift;
    private final int mask;

    /** The polarity packet that is being decoded. */
    private int eventsLeft;
    private int eventBytes;
    private int timePlace;
    private long overflowUs;

    /** Makes a reader at the first packet; a null source accepts the packets of all sources. */
    Aedat3Reader(RecordingFile file, RecordingOptions options, String version, Integer source, ChipChoice choice) {
        super(file, options, "AEDAT " + version, choice.name(), choice.sensor());
        this.source = source == null ? ANY_SOURCE : source;
        boolean is30 = version.equals("3.0");
        xShift = is30 ? X_SHIFT_30 : X_SHIFT_31;
        yShift = is30 ? Y_SHIFT_30 : Y_SHIFT_31;
        mask = is30 ? MASK_30 : MASK_31;
    }

    @Override
    boolean decode(EventBatch batch) throws IOException, MalformedRecordingException {
        int n = 0;
        try {
            while (n < batch.capacity()) {
                if (eventsLeft == 0) {
                    if (!readPacketHeader(n)) {
                        return false;
                    }
                } else if (file.require(eventBytes)) {
                    n = decodeEvents(batch, n);
                } else {
                    throw malformed(eventNumber(n), file.offset(), "truncated, a packet must hold " + eventsLeft
                            + " more events of " + eventBytes + " bytes but had " + file.available() + " bytes");
                }
            }
            return true;
        } finally {
            deliver(batch, n);
        }
    }

    private int decodeEvents(EventBatch batch, int from) throws MalformedRecordingException {
        byte[] buffer = file.buffer;
        int stride = eventBytes;
        int timeAt = timePlace;
        long overflow = overflowUs;
        int p = file.position;
        int end = p + Math.min(Math.min(eventsLeft, batch.capacity() - from), file.available() / stride) * stride;
        int width = sensor().width();
        int height = sensor().height();
        int n = from;
        try {
            for (; p < end; p += stride) {
                int word = (int) INT.get(buffer, p);
                if ((word & VALID) == 0) {
                    invalid++;
                    continue;
                }
                int column = word >>> xShift & mask;
                int row = word >>> yShift & mask;
                if (column >= width || row >= height) {
                    outside(column, row, eventNumber(n), offsetOf(p));
                    continue;
                }
                long time = overflow + (int) INT.get(buffer, p + timeAt);
                note(n, offsetOf(p));
                batch.timeUs[n] = time;
                batch.x[n] = (short) column;
                batch.y[n] = (short) row;
                batch.polarity[n] = (byte) ((word >>> ON_SHIFT & 1) * 2 - 1);
                n++;
            }
        } finally {
            eventsLeft -= (p - file.position) / stride;
            file.position = p;
        }
        return n;
    }

    /** Reads a packet's header, and skips the packet unless it holds polarity events of the selected source. */
    private boolean readPacketHeader(int n) throws IOException, MalformedRecordingException {
        if (!file.require(PACKET_HEADER_BYTES)) {
            if (file.available() == 0) {
                return false;
            }
            throw malformed(eventNumber(n), file.offset(), "truncated, a packet's header must have "
                    + PACKET_HEADER_BYTES + " bytes but had " + file.available());
        }
        long offset = file.offset();
        int at = file.position;
        int type = (short) SHORT.get(file.buffer, at);
        int packetSource = (short) SHORT.get(file.buffer, at + SOURCE_AT);
        int bytes = (int) INT.get(file.buffer, at + EVENT_BYTES_AT);
        int place = (int) INT.get(file.buffer, at + TIME_PLACE_AT);
        int overflow = (int) INT.get(file.buffer, at + TIME_OVERFLOW_AT);
        int number = (int) INT.get(file.buffer, at + NUMBER_AT);
        if (number < 0) {
            throw malformed(eventNumber(n), offset, "malformed, a packet's number of events must not be negative "
                    + "but was " + number);
        }
        if (bytes < POLARITY_BYTES) {
            throw malformed(eventNumber(n), offset, "malformed, an event must have at least " + POLARITY_BYTES
                    + " bytes but had " + bytes);
        }
        if (type == POLARITY && bytes > RecordingFile.BUFFER_BYTES) {
            throw malformed(eventNumber(n), offset, "malformed, an event must have at most "
                    + RecordingFile.BUFFER_BYTES + " bytes but had " + bytes);
        }
        if (type == POLARITY && (place < Integer.BYTES || place > bytes - Integer.BYTES)) {
            throw malformed(eventNumber(n), offset, "malformed, an event's time must lie between byte 4 and "
                    + (bytes - Integer.BYTES) + " of it but lay at " + place);
        }
        if (overflow < 0) {
            throw malformed(eventNumber(n), offset, "malformed, a packet's overflow of time must not be negative "
                    + "but was " + overflow);
        }
        file.position += PACKET_HEADER_BYTES;
        boolean isOurs = source == ANY_SOURCE || packetSource == source;
        if (type == POLARITY && isOurs) {
            eventsLeft = number;
            eventBytes = bytes;
            timePlace = place;
            overflowUs = (long) overflow << TIME_BITS;
            return true;
        }
        if (type == POLARITY) {
            addFault("source", () -> at(eventNumber(n), offset) + "unsupported, a packet of events must come from "
                    + "source " + source + " but came from " + packetSource + "; it was passed over");
        }
        long size = (long) number * bytes;
        long have = Math.min(size, file.size() - file.offset());
        file.seek(file.offset() + have);
        if (have < size) {
            throw malformed(eventNumber(n), offset, "truncated, a packet must have " + (PACKET_HEADER_BYTES + size)
                    + " bytes but had " + (PACKET_HEADER_BYTES + have));
        }
        count(isOurs ? type : POLARITY, number);
        return true;
    }

    private void count(int type, int number) {
        switch (type) {
            case SPECIAL:
                triggers += number;
                break;
            case FRAME:
                frames += number;
                break;
            case IMU6:
            case IMU9:
                imuSamples += number;
                break;
            default:
                otherRecords += number;
                break;
        }
    }
}
