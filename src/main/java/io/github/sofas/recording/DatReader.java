package io.github.sofas.recording;

import io.github.sofas.event.EventBatch;
import java.io.IOException;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;
import java.util.Set;

/**
 * Reads Prophesee's DAT files. A file has a header ({@link PropheseeHeader}), a byte with the type of the events and a
 * byte with their size. Little-endian records follow, each with the time in µs and a word with polarity, y and x. x
 * runs right, y down. Time overflows after 32 bits. Version 1 packs the word in other bits. Holds one file buffer.
 *
 * <p>Source: openeb (prophesee-ai/openeb), {@code dat_tools.py}; version 1 as Prophesee's Matlab tools read it.
 */
final class DatReader extends RecordingReader {
    /** Types whose records hold pixel and polarity: Event2D and EventCD. */
    private static final Set<Integer> CHANGE_EVENTS = Set.of(0, 12);
    private static final int RECORD_BYTES = 8;
    private static final String VERSION_1 = "1";
    private static final VarHandle INT = MethodHandles.byteArrayViewVarHandle(int[].class, ByteOrder.LITTLE_ENDIAN);
    private static final long WRAP_US = 1L << 32;

    private final int xMask;
    private final int yShift;
    private final int yMask;
    private final int onShift;

    private DatReader(RecordingFile file, RecordingOptions options, boolean isVersion1, ChipChoice choice) {
        super(file, options, isVersion1 ? "DAT 1" : "DAT 2", choice.name(), choice.sensor());
        xMask = isVersion1 ? 0x1FF : 0x3FFF;
        yShift = isVersion1 ? 9 : 14;
        yMask = isVersion1 ? 0xFF : 0x3FFF;
        onShift = isVersion1 ? 17 : 28;
    }

    /**
     * Reads the two bytes after the header and makes a reader at the first record.
     *
     * @throws MalformedRecordingException where the two bytes announce records of another kind
     */
    static DatReader open(RecordingFile file, RecordingOptions options, PropheseeHeader header, ChipChoice choice)
            throws IOException, MalformedRecordingException {
        String place = "[" + file.name + "] header at byte " + file.offset() + ": ";
        if (!file.require(2)) {
            throw new MalformedRecordingException(place + "truncated, the type and size of events must have 2 bytes "
                    + "but had " + file.available());
        }
        int type = file.buffer[file.position] & 0xFF;
        int bytes = file.buffer[file.position + 1] & 0xFF;
        if (!CHANGE_EVENTS.contains(type) || bytes != RECORD_BYTES) {
            throw new MalformedRecordingException(place + "unsupported, events must be of type 0 or 12 and of "
                    + RECORD_BYTES + " bytes but were of type " + type + " and " + bytes + " bytes");
        }
        file.position += 2;
        return new DatReader(file, options, VERSION_1.equals(header.value("version")), choice);
    }

    @Override
    boolean decode(EventBatch batch) throws IOException, MalformedRecordingException {
        if (!file.require(RECORD_BYTES)) {
            if (file.available() > 0) {
                throw malformed(eventNumber(0), file.offset(), "truncated, a record must have " + RECORD_BYTES
                        + " bytes but had " + file.available());
            }
            return false;
        }
        byte[] buffer = file.buffer;
        int lastRecord = file.limit - RECORD_BYTES;
        int p = file.position;
        int capacity = batch.capacity();
        int width = sensor().width();
        int height = sensor().height();
        int n = 0;
        try {
            for (; p <= lastRecord && n < capacity; p += RECORD_BYTES) {
                int word = (int) INT.get(buffer, p + Integer.BYTES);
                int column = word & xMask;
                int row = word >>> yShift & yMask;
                if (column >= width || row >= height) {
                    outside(column, row, eventNumber(n), offsetOf(p));
                    continue;
                }
                note(n, offsetOf(p));
                batch.timeUs[n] = (int) INT.get(buffer, p) & 0xFFFFFFFFL;
                batch.x[n] = (short) column;
                batch.y[n] = (short) row;
                batch.polarity[n] = (byte) ((word >>> onShift & 1) * 2 - 1);
                n++;
            }
        } finally {
            file.position = p;
            deliver(batch, n);
        }
        return true;
    }

    /** Treats a step back by at least half the range as an overflow. */
    @Override
    long step(long fromUs, long toUs) {
        return overflowingStep(fromUs, toUs, WRAP_US, WRAP_US / 2);
    }
}
