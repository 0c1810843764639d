package io.github.sofas.recording;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;

/**
 * Constants of Prophesee's RAW files. A file has a header ({@link PropheseeHeader}), then little-endian words of 16
 * bits (EVT 3.0), 32 bits (EVT 2.0) or 64 bits (EVT 2.1). The four highest bits of a word are its type. x runs right, y
 * down.
 *
 * <p>Time comes in parts. The high bits come in a word of their own from time to time; the low bits come with each
 * event (2.0, 2.1) or in words of their own (3.0). Time overflows after 34 bits, in 3.0 after 24 bits (every 16.8 s).
 *
 * <p>Source: Prophesee's description of its data encodings and openeb (prophesee-ai/openeb), {@code hal/decoders}.
 */
final class EvtFormat {
    static final VarHandle SHORT = MethodHandles.byteArrayViewVarHandle(short[].class, ByteOrder.LITTLE_ENDIAN);
    static final VarHandle INT = MethodHandles.byteArrayViewVarHandle(int[].class, ByteOrder.LITTLE_ENDIAN);
    static final VarHandle LONG = MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.LITTLE_ENDIAN);

    /** Word types of EVT 2.0 and 2.1. */
    static final int OFF_2 = 0x0;
    static final int ON_2 = 0x1;

    /** Word types of all versions. */
    static final int TIME_HIGH = 0x8;
    static final int TRIGGER = 0xA;

    /** Word types of EVT 3.0. */
    static final int ROW_3 = 0x0;
    static final int COLUMN_3 = 0x2;
    static final int VECTOR_BASE_3 = 0x3;
    static final int VECTOR_12_3 = 0x4;
    static final int VECTOR_8_3 = 0x5;
    static final int TIME_LOW_3 = 0x6;

    /** EVT 2.0: bits of a word. */
    static final int TYPE_SHIFT_2 = 28;
    static final int TIME_HIGH_MASK_2 = 0xFFFFFFF;
    static final int TIME_LOW_BITS_2 = 6;
    static final int TIME_SHIFT_2 = 22;
    static final int TIME_MASK_2 = 0x3F;
    static final int X_SHIFT_2 = 11;
    static final int TIME_RANGE_BITS_2 = 34;
    /**
     * Smallest step back, in µs, that is an overflow: nearly the whole range, because the high bits come every few µs.
     */
    static final long WRAP_STEP_US_2 = (1L << TIME_RANGE_BITS_2) - 60_000_000;

    /** EVT 3.0: bits of a word. */
    static final int TYPE_SHIFT_3 = 12;
    static final int PAYLOAD_MASK_3 = 0xFFF;
    static final int ON_3 = 1 << 11;
    static final int TIME_BITS_3 = 12;

    /** Mask of a coordinate, in all versions. */
    static final int COORDINATE_MASK = 0x7FF;
    static final int VECTOR_8_BITS = 8;
    static final int VECTOR_12_BITS = 12;

    private EvtFormat() {
    }
}
