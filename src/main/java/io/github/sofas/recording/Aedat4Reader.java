package io.github.sofas.recording;

import static io.github.sofas.recording.Aedat4Format.DATA_TABLE;
import static io.github.sofas.recording.Aedat4Format.ELEMENTS;
import static io.github.sofas.recording.Aedat4Format.ENTRY_ELEMENTS;
import static io.github.sofas.recording.Aedat4Format.ENTRY_PACKET;
import static io.github.sofas.recording.Aedat4Format.EVENTS;
import static io.github.sofas.recording.Aedat4Format.EVENT_BYTES;
import static io.github.sofas.recording.Aedat4Format.EVENT_PIXEL_AT;
import static io.github.sofas.recording.Aedat4Format.EVENT_POLARITY_AT;
import static io.github.sofas.recording.Aedat4Format.FRAMES;
import static io.github.sofas.recording.Aedat4Format.IDENTIFIER_AT;
import static io.github.sofas.recording.Aedat4Format.IDENTIFIER_BYTES;
import static io.github.sofas.recording.Aedat4Format.IMU;
import static io.github.sofas.recording.Aedat4Format.INT;
import static io.github.sofas.recording.Aedat4Format.LONG;
import static io.github.sofas.recording.Aedat4Format.MAGIC_BYTES;
import static io.github.sofas.recording.Aedat4Format.MAX_PACKED_BYTES;
import static io.github.sofas.recording.Aedat4Format.MAX_UNPACKED_BYTES;
import static io.github.sofas.recording.Aedat4Format.PACKET_HEADER_BYTES;
import static io.github.sofas.recording.Aedat4Format.ROOT_AT;
import static io.github.sofas.recording.Aedat4Format.TRIGGERS;

import io.github.sofas.event.EventBatch;
import io.github.sofas.recording.Aedat4Header.Stream;
import java.io.IOException;
import java.util.Map;
import java.util.Optional;

/**
 * Reads AEDAT 4.0. Holds the file buffer and one packet, packed and unpacked. Packets of recorders stay below a few
 * MiB; packets of more than 128 MiB, packed or unpacked, are refused.
 *
 * <p>The byte in a message is that of the packet that holds the event. Where a file has several streams of events, only
 * the first is read.
 */
final class Aedat4Reader extends RecordingReader {
    private final Aedat4Header header;
    private final int eventStream;
    private final PacketUnpacker unpacker;
    /** Where packets end: at the data table, or at the end of a file that has none. */
    private final long packetsEnd;
    private byte[] packed = new byte[1 << 16];

    /** The packet whose events are being delivered. */
    private byte[] packet = packed;
    private long packetOffset;
    private int nextEventAt;
    private int eventsLeft;
    /** The fault after the packet's last whole event; null where there is none. */
    private String packetFault;

    Aedat4Reader(RecordingFile file, RecordingOptions options, Aedat4Header header, int eventStream, ChipChoice choice)
            throws IOException {
        super(file, options, "AEDAT 4.0", choice.name(), choice.sensor());
        this.header = header;
        this.eventStream = eventStream;
        unpacker = new PacketUnpacker(header.compression(), MAX_UNPACKED_BYTES);
        long first = file.offset();
        long size = file.size();
        if (header.dataTableAt() != -1 && header.dataTableAt() < first) {
            addFault("table", () -> at(0, MAGIC_BYTES) + "malformed, the data table must not start before byte " + first
                    + " but starts at " + header.dataTableAt());
        }
        packetsEnd = header.dataTableAt() >= first && header.dataTableAt() <= size ? header.dataTableAt() : size;
        for (Map.Entry<Integer, Stream> stream : header.streams().entrySet()) {
            if (EVENTS.equals(stream.getValue().type()) && stream.getKey() != eventStream) {
                addFault("streams", () -> at(0, MAGIC_BYTES) + "unsupported, a recording must have one stream of "
                        + "events but stream " + stream.getKey() + " holds some too; only stream "
                        + eventStream + " is read");
            }
        }
    }

    @Override
    public Optional<String> compression() {
        return Optional.of(header.compression().label);
    }

    @Override
    boolean decode(EventBatch batch) throws IOException, MalformedRecordingException {
        int n = 0;
        try {
            while (n < batch.capacity()) {
                if (eventsLeft > 0) {
                    n = decodeEvents(batch, n);
                } else if (packetFault != null) {
                    throw malformed(eventNumber(n), packetOffset, packetFault);
                } else if (!readPacket(n)) {
                    return false;
                }
            }
            return true;
        } finally {
            deliver(batch, n);
        }
    }

    private int decodeEvents(EventBatch batch, int from) throws MalformedRecordingException {
        byte[] bytes = packet;
        int p = nextEventAt;
        int end = p + Math.min(eventsLeft, batch.capacity() - from) * EVENT_BYTES;
        long[] timeUs = batch.timeUs;
        short[] x = batch.x;
        short[] y = batch.y;
        byte[] polarity = batch.polarity;
        int width = sensor().width();
        int height = sensor().height();
        int n = from;
        try {
            for (; p < end; p += EVENT_BYTES) {
                int pixel = (int) INT.get(bytes, p + EVENT_PIXEL_AT);
                int column = (short) pixel;
                int row = pixel >> 16;
                if (column < 0 || column >= width || row < 0 || row >= height) {
                    outside(column, row, eventNumber(n), packetOffset);
                    continue;
                }
                note(n, packetOffset);
                timeUs[n] = (long) LONG.get(bytes, p);
                x[n] = (short) column;
                y[n] = (short) row;
                polarity[n] = (byte) (bytes[p + EVENT_POLARITY_AT] != 0 ? 1 : -1);
                n++;
            }
        } finally {
            eventsLeft -= (p - nextEventAt) / EVENT_BYTES;
            nextEventAt = p;
        }
        return n;
    }

    /** Reads one packet of any stream. */
    private boolean readPacket(int n) throws IOException, MalformedRecordingException {
        packetOffset = file.offset();
        long room = packetsEnd - packetOffset;
        if (room == 0) {
            finish(n);
            return false;
        }
        if (room < PACKET_HEADER_BYTES || !file.require(PACKET_HEADER_BYTES)) {
            throw malformed(eventNumber(n), packetOffset, endWord() + ", a packet's header must have "
                    + PACKET_HEADER_BYTES + " bytes but had " + Math.min(room, file.available()));
        }
        int id = (int) INT.get(file.buffer, file.position);
        long size = (int) INT.get(file.buffer, file.position + 4) & 0xFFFFFFFFL;
        file.position += PACKET_HEADER_BYTES;
        room -= PACKET_HEADER_BYTES;
        Stream stream = header.streams().get(id);
        if (stream == null) {
            addFault("undeclared", () -> at(eventNumber(n), packetOffset) + "malformed, a packet's stream must be "
                    + "declared in the header but was " + id);
        }
        boolean isRead = stream != null
                && (id == eventStream || IMU.equals(stream.type()) || TRIGGERS.equals(stream.type())
                || frameReceiver != null && FRAMES.equals(stream.type()));
        long have = Math.min(size, room);
        if (isRead && size <= MAX_PACKED_BYTES) {
            if (packed.length < have) {
                packed = new byte[(int) Math.min(MAX_PACKED_BYTES, have + (have >> 1))];
            }
            have = file.read(packed, 0, (int) have);
        } else {
            file.seek(file.offset() + have);
        }
        if (isRead && size <= MAX_PACKED_BYTES && have > 0) {
            unpacker.unpack(packed, (int) have);
            if (FRAMES.equals(stream.type())) {
                frames++;
                deliverFrame(id, n, have < size);
            } else {
                openPacket(id, stream.type(), n, have < size);
            }
        } else if (stream != null && FRAMES.equals(stream.type())) {
            frames++;
        } else {
            otherRecords++;
        }
        if (have < size) {
            packetFault = endWord() + ", a packet must have " + size + " bytes but had " + have;
        } else if (isRead && size > MAX_PACKED_BYTES && !FRAMES.equals(stream.type())) {
            packetFault = "unsupported, a packet must have at most " + MAX_PACKED_BYTES + " bytes but had " + size;
        }
        return true;
    }

    /** Delivers the frame just unpacked. A damaged frame costs no events, and the next packet's place is known. */
    private void deliverFrame(int id, int n, boolean isCut) {
        String fault = unpacker.fault();
        if (fault == null) {
            try {
                frameReceiver.accept(Aedat4Frames.decode(unpacker.output(), unpacker.length(), sensor()));
            } catch (Aedat4Frames.MalformedFrameException e) {
                fault = e.getMessage();
            }
        }
        if (fault != null && !isCut) {
            String rule = fault;
            addFault("packet" + id, () -> at(eventNumber(n), packetOffset) + rule);
        }
    }

    /**
     * The word for a packet that does not fit: malformed where the data table follows it, else truncated, since it was
     * cut off with the file.
     */
    private String endWord() {
        return packetsEnd == header.dataTableAt() ? "malformed" : "truncated";
    }

    /** Finds the elements of the packet just unpacked. Events are then delivered; other elements are only counted. */
    private void openPacket(int id, String type, int n, boolean isCut) {
        byte[] bytes = unpacker.output();
        int length = unpacker.length();
        String fault = unpacker.fault();
        int count = 0;
        int whole = 0;
        int start = 0;
        int elementBytes = EVENTS.equals(type) ? EVENT_BYTES : Integer.BYTES;
        if (fault == null || length >= IDENTIFIER_AT + IDENTIFIER_BYTES) {
            if (!FlatTable.hasIdentifier(bytes, IDENTIFIER_AT, length, type)) {
                fault = "malformed, a packet of stream " + id + " must have the identifier " + type
                        + " but had another";
            } else {
                try {
                    FlatTable table = FlatTable.root(bytes, ROOT_AT, length);
                    count = table.vectorLength(ELEMENTS);
                    start = table.vectorAt(ELEMENTS);
                    whole = Math.max(0, Math.min(count, (length - start) / elementBytes));
                } catch (IndexOutOfBoundsException e) {
                    fault = fault != null ? fault
                            : "malformed, a packet's table must lie within its " + length + " bytes but points outside";
                }
                if (fault == null && whole != count) {
                    fault = "malformed, a packet must have room for its " + Integer.toUnsignedString(count)
                            + " elements but had for " + whole;
                }
            }
        }
        if (id == eventStream) {
            packet = bytes;
            nextEventAt = start;
            eventsLeft = whole;
            packetFault = fault;
            return;
        }
        if (IMU.equals(type)) {
            imuSamples += whole;
        } else {
            triggers += whole;
        }
        if (fault != null && !isCut) {
            // No event is lost, and the next packet's place is known.
            String rule = fault;
            addFault("packet" + id, () -> at(eventNumber(n), packetOffset) + rule);
        }
    }

    /** Checks the data table that the header announces to follow the packets. */
    private void finish(int n) throws IOException, MalformedRecordingException {
        long tableAt = header.dataTableAt();
        if (tableAt > packetsEnd) {
            throw malformed(eventNumber(n), packetsEnd, "truncated, the data table must start at byte " + tableAt
                    + " but the file ends");
        }
        if (tableAt != packetsEnd) {
            return;
        }
        int size = (int) Math.min(MAX_PACKED_BYTES, file.size() - tableAt);
        packed = packed.length < size ? new byte[size] : packed;
        unpacker.unpack(packed, file.read(packed, 0, size));
        String fault = unpacker.fault();
        if (fault == null) {
            fault = tableFault(unpacker.output(), unpacker.length(), eventNumber(n));
        }
        if (fault != null) {
            String rule = fault;
            addFault("table", () -> at(eventNumber(n), tableAt) + "data table: " + rule);
        }
    }

    /** Compares the data table with the events read; returns null where they agree. */
    private String tableFault(byte[] bytes, int length, long found) {
        if (!FlatTable.hasIdentifier(bytes, IDENTIFIER_AT, length, DATA_TABLE)) {
            return "malformed, it must have the identifier " + DATA_TABLE + " but had another";
        }
        int announced = (int) INT.get(bytes, 0);
        if (announced > length - Integer.BYTES) {
            return "truncated, it must have " + announced + " bytes but had " + (length - Integer.BYTES);
        }
        try {
            FlatTable table = FlatTable.root(bytes, ROOT_AT, length);
            int entryAt = table.vectorAt(ELEMENTS);
            long events = 0;
            for (int left = table.vectorLength(ELEMENTS); left > 0; left--, entryAt += Integer.BYTES) {
                FlatTable entry = table.tableAt(entryAt);
                if (entry.structInt(ENTRY_PACKET, 0) == eventStream) {
                    events += entry.longField(ENTRY_ELEMENTS, 0);
                }
            }
            // Some recorders count no elements in the table.
            return events == found || events == 0 ? null
                    : "malformed, it must count the " + found + " events of the packets but counted " + events;
        } catch (IndexOutOfBoundsException e) {
            return "malformed, it must lie within its " + length + " bytes but points outside";
        }
    }

    @Override
    void release() {
        unpacker.close();
        packed = packet = new byte[0];
        eventsLeft = 0;
    }
}
