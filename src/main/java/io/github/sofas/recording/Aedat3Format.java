package io.github.sofas.recording;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;

/**
 * Constants of AEDAT 3.0 and 3.1, as cAER and jAER write them. A file has header lines up to {@code #!END-HEADER}, then
 * little-endian packets, each with a header and events of one type and size. x runs right, y down.
 *
 * <p>Source: inivation's AEDAT 3.1 specification; the bit fields of 3.0 from jAER (SensorsINI/jaer a1db449505).
 */
final class Aedat3Format {
    static final VarHandle SHORT = MethodHandles.byteArrayViewVarHandle(short[].class, ByteOrder.LITTLE_ENDIAN);
    static final VarHandle INT = MethodHandles.byteArrayViewVarHandle(int[].class, ByteOrder.LITTLE_ENDIAN);

    /** The only supported encoding of packets; other encodings compress times or frames. */
    static final String RAW = "RAW";

    /** A packet's header: type, source (16 bits each), then six numbers of 32 bits, of which four are read. */
    static final int PACKET_HEADER_BYTES = 28;
    static final int SOURCE_AT = 2;
    static final int EVENT_BYTES_AT = 4;
    static final int TIME_PLACE_AT = 8;
    static final int TIME_OVERFLOW_AT = 12;
    static final int NUMBER_AT = 20;

    static final int SPECIAL = 0;
    static final int POLARITY = 1;
    static final int FRAME = 2;
    static final int IMU6 = 3;
    static final int IMU9 = 4;

    /** Bytes of a polarity event: a word and a time. */
    static final int POLARITY_BYTES = 8;
    static final int VALID = 1;
    static final int ON_SHIFT = 1;
    static final int Y_SHIFT_31 = 2;
    static final int X_SHIFT_31 = 17;
    static final int MASK_31 = 0x7FFF;
    static final int Y_SHIFT_30 = 4;
    static final int X_SHIFT_30 = 18;
    static final int MASK_30 = 0x3FFF;

    /** Bits of time in an event; the overflow number of the packet counts beyond them. */
    static final int TIME_BITS = 31;

    private Aedat3Format() {
    }
}
