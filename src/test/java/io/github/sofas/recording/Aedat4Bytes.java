package io.github.sofas.recording;

import com.github.luben.zstd.Zstd;
import com.google.flatbuffers.FlatBufferBuilder;
import io.github.sofas.recording.Aedat4Format.Compression;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import org.apache.commons.compress.compressors.lz4.FramedLZ4CompressorOutputStream;
import org.apache.commons.compress.compressors.lz4.FramedLZ4CompressorOutputStream.BlockSize;
import org.apache.commons.compress.compressors.lz4.FramedLZ4CompressorOutputStream.Parameters;

/** Builds AEDAT 4.0 files: valid unless a field is spoiled. */
final class Aedat4Bytes {
    static final int EVENTS_ID = 7;
    static final int IMU_ID = 2;
    static final int FRAMES_ID = 3;
    static final int TRIGGERS_ID = 4;

    Compression compression = Compression.NONE;
    int compressionCode = -1;
    String streams = stream(IMU_ID, "IMUS", "") + stream(FRAMES_ID, "FRME", "") + stream(TRIGGERS_ID, "TRIG", "")
            + stream(EVENTS_ID, "EVTS", size("16", "12"));
    String xml;
    boolean dataTable = true;
    /** Where the header says that the table is, if not where it is. */
    Long dataTableAt;
    long tableEvents = -1;
    private final ByteArrayOutputStream packets = new ByteArrayOutputStream();
    private long events;

    static String stream(int id, String type, String info) {
        return "<node name=\"" + id + "\"><attr key=\"typeIdentifier\" type=\"string\">" + type
                + "</attr><node name=\"info\">"
                + info + "</node></node>";
    }

    static String size(String width, String height) {
        return "<attr key=\"sizeX\" type=\"int\">" + width + "</attr><attr key=\"sizeY\" type=\"int\">" + height
                + "</attr>"
                + "<attr key=\"source\" type=\"string\">DAVIS346_0001</attr>";
    }

    /** Adds a packet of events, each t x y polarity. */
    Aedat4Bytes events(long[]... rows) throws IOException {
        events += rows.length;
        return packet(EVENTS_ID, pack(eventPayload("EVTS", rows.length, rows)));
    }

    /** An event packet that announces another number of events than it holds. */
    static byte[] eventPayload(String identifier, int announced, long[]... rows) {
        FlatBufferBuilder builder = new FlatBufferBuilder();
        builder.startVector(16, rows.length, 8);
        for (int i = rows.length - 1; i >= 0; i--) {
            builder.prep(8, 16);
            builder.pad(3);
            builder.putByte((byte) rows[i][3]);
            builder.putShort((short) rows[i][2]);
            builder.putShort((short) rows[i][1]);
            builder.putLong(rows[i][0]);
        }
        int vector = builder.endVector();
        byte[] bytes = finish(builder, vector, identifier);
        if (announced != rows.length) {
            FlatTable table = FlatTable.root(bytes, 4, bytes.length);
            ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).putInt(table.vectorAt(4) - 4, announced);
        }
        return bytes;
    }

    /** A packet of tables without fields, which is all that a count needs. */
    static byte[] tablePayload(String identifier, int elements) {
        FlatBufferBuilder builder = new FlatBufferBuilder();
        int[] tables = new int[elements];
        for (int i = 0; i < elements; i++) {
            builder.startTable(1);
            tables[i] = builder.endTable();
        }
        return finish(builder, builder.createVectorOfTables(tables), identifier);
    }

    /** A frame of that format at a place of the sensor. */
    static byte[] framePayload(long timeUs, int format, int width, int height, int left, int top, byte... pixels) {
        FlatBufferBuilder builder = new FlatBufferBuilder().forceDefaults(true);
        int vector = builder.createByteVector(pixels);
        builder.startTable(11);
        builder.addLong(0, timeUs, 0);
        builder.addByte(5, (byte) format, 0);
        builder.addShort(6, (short) width, 0);
        builder.addShort(7, (short) height, 0);
        builder.addShort(8, (short) left, 0);
        builder.addShort(9, (short) top, 0);
        builder.addOffset(10, vector, 0);
        builder.finishSizePrefixed(builder.endTable(), "FRME");
        return builder.sizedByteArray();
    }

    private static byte[] finish(FlatBufferBuilder builder, int vector, String identifier) {
        builder.startTable(1);
        builder.addOffset(0, vector, 0);
        builder.finishSizePrefixed(builder.endTable(), identifier);
        return builder.sizedByteArray();
    }

    byte[] pack(byte[] payload) throws IOException {
        switch (compression) {
            case NONE:
                return payload;
            case ZSTD:
            case ZSTD_HIGH:
                return Zstd.compress(payload);
            default:
                return lz4(payload, new Parameters(BlockSize.K64, false, false, true));
        }
    }

    static byte[] lz4(byte[] payload, Parameters parameters) throws IOException {
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        try (FramedLZ4CompressorOutputStream out = new FramedLZ4CompressorOutputStream(packed, parameters)) {
            out.write(payload);
        }
        return packed.toByteArray();
    }

    Aedat4Bytes packet(int id, byte[] packed) {
        return packet(id, packed.length, packed);
    }

    Aedat4Bytes packet(int id, int announced, byte[] packed) {
        packets.writeBytes(ByteBuffer.allocate(8).order(ByteOrder.LITTLE_ENDIAN).putInt(id).putInt(announced).array());
        packets.writeBytes(packed);
        return this;
    }

    byte[] build() throws IOException {
        long at = 18L + header(0).length + packets.size();
        byte[] header = header(dataTableAt != null ? dataTableAt : dataTable ? at : -1);
        ByteArrayOutputStream all = new ByteArrayOutputStream();
        all.writeBytes("#!AER-DAT4.0\r\n".getBytes());
        all.writeBytes(ByteBuffer.allocate(4).order(ByteOrder.LITTLE_ENDIAN).putInt(header.length).array());
        all.writeBytes(header);
        all.writeBytes(packets.toByteArray());
        if (dataTable) {
            all.writeBytes(pack(table()));
        }
        return all.toByteArray();
    }

    int firstPacketAt() {
        return 18 + header(0).length;
    }

    private byte[] header(long tableAt) {
        FlatBufferBuilder builder = new FlatBufferBuilder().forceDefaults(true);
        int text = builder.createString(xml != null ? xml
                : "<dv version=\"2.0\"><node name=\"outInfo\">" + streams + "</node></dv>");
        builder.startTable(3);
        builder.addInt(0, compressionCode >= 0 ? compressionCode : compression.ordinal(), 0);
        builder.addLong(1, tableAt, -1);
        builder.addOffset(2, text, 0);
        builder.finish(builder.endTable(), "IOHE");
        byte[] bytes = builder.sizedByteArray();
        return Arrays.copyOf(bytes, bytes.length);
    }

    /** One entry with all events. */
    private byte[] table() {
        FlatBufferBuilder builder = new FlatBufferBuilder();
        builder.startTable(3);
        builder.addLong(2, tableEvents >= 0 ? tableEvents : events, 0);
        builder.prep(4, 8);
        builder.putInt(1);
        builder.putInt(EVENTS_ID);
        builder.addStruct(1, builder.offset(), 0);
        int entry = builder.endTable();
        return finish(builder, builder.createVectorOfTables(new int[] {entry}), "FTAB");
    }
}
