package io.github.sofas.recording;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;

/**
 * Constants of AEDAT 4.0, as DV and dv-processing write it, little-endian throughout. A file consists of a magic line,
 * the FlatBuffer {@code IOHE}, packets, and the data table {@code FTAB}. {@code IOHE} holds the compression, the place
 * of the data table and an XML text that declares the streams. A packet holds a stream id, a size and a payload. Once
 * unpacked, a payload is a FlatBuffer with a length prefix. The data table is missing where recording was cut short. x
 * runs right, y down.
 *
 * <p>Source: gitlab.com/inivation/dv/dv-processing, include/dv-processing/io and data.
 */
final class Aedat4Format {
    static final VarHandle INT = MethodHandles.byteArrayViewVarHandle(int[].class, ByteOrder.LITTLE_ENDIAN);
    static final VarHandle LONG = MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.LITTLE_ENDIAN);

    static final int MAGIC_BYTES = 14;
    /** Places of the root table's offset and of the identifier in a FlatBuffer, counted from its length prefix. */
    static final int ROOT_AT = 4;
    static final int IDENTIFIER_AT = 8;
    static final int IDENTIFIER_BYTES = 4;

    static final String HEADER = "IOHE";
    static final String EVENTS = "EVTS";
    static final String FRAMES = "FRME";
    static final String IMU = "IMUS";
    static final String TRIGGERS = "TRIG";
    static final String DATA_TABLE = "FTAB";

    /** Fields of the IOHE table, as places in a vtable. */
    static final int HEADER_COMPRESSION = 4;
    static final int HEADER_DATA_TABLE = 6;
    static final int HEADER_XML = 8;
    /** The only field of the payloads' tables and of FTAB: a vector. */
    static final int ELEMENTS = 4;
    /** Fields of an entry of FTAB. */
    static final int ENTRY_PACKET = 6;
    static final int ENTRY_ELEMENTS = 8;

    /** Fields of a frame. */
    static final int FRAME_TIME = 4;
    static final int FRAME_FORMAT = 14;
    static final int FRAME_WIDTH = 16;
    static final int FRAME_HEIGHT = 18;
    static final int FRAME_LEFT = 20;
    static final int FRAME_TOP = 22;
    static final int FRAME_PIXELS = 24;
    /** Formats of a frame, as OpenCV's codes: one byte per pixel; blue, green and red; the same with opacity. */
    static final int FORMAT_GREY = 0;
    static final int FORMAT_BGR = 16;
    static final int FORMAT_BGRA = 24;

    static final int PACKET_HEADER_BYTES = 8;
    static final int EVENT_BYTES = 16;
    static final int EVENT_PIXEL_AT = 8;
    static final int EVENT_POLARITY_AT = 12;

    /** Largest accepted sizes, so that a false size costs no more memory than this; recorders stay far below. */
    static final int MAX_HEADER_BYTES = 4 << 20;
    static final int MAX_PACKED_BYTES = 128 << 20;
    static final int MAX_UNPACKED_BYTES = 128 << 20;

    /** How payloads are packed, in the order of the codes. */
    enum Compression {
        NONE("none"), LZ4("LZ4"), LZ4_HIGH("LZ4_HIGH"), ZSTD("ZSTD"), ZSTD_HIGH("ZSTD_HIGH");

        final String label;

        Compression(String label) {
            this.label = label;
        }
    }

    private Aedat4Format() {
    }
}
