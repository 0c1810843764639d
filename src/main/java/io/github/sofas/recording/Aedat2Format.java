package io.github.sofas.recording;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;

/**
 * Constants of AEDAT 1.0 and 2.0, as jAER writes them. A file has header lines that start with {@code #}, then
 * big-endian records of an address and a signed 32-bit time in µs. An address has 16 bits in 1.0 and 32 bits in 2.0.
 * For events of all chips, raw x runs from right to left and raw y from bottom to top.
 *
 * <p>Source: jAER (SensorsINI/jaer a1db449505), DVS128 and DavisBaseCamera.
 */
final class Aedat2Format {
    static final String CHIP_LINE = "# AEChip: ";
    static final String END_LINE = "#End Of ASCII Header";

    static final int RECORD_BYTES_1 = 6;
    static final int RECORD_BYTES_2 = 8;

    static final VarHandle INT = MethodHandles.byteArrayViewVarHandle(int[].class, ByteOrder.BIG_ENDIAN);
    static final VarHandle SHORT = MethodHandles.byteArrayViewVarHandle(short[].class, ByteOrder.BIG_ENDIAN);

    /** Bits 15 and 31 of a DVS128 address mark an external or synchronisation event. */
    static final int DVS128_SPECIAL = 0x80008000;
    static final int DVS128_OFF = 1;
    static final int DVS128_X_SHIFT = 1;
    static final int DVS128_Y_SHIFT = 8;
    static final int DVS128_MASK = 0x7F;
    /** Address bits that no DVS128 sets. */
    static final int DVS128_UNUSED = 0x7FFF0000;

    /** Bit 31 of a DAVIS address marks an intensity sample or a word of an IMU sample. */
    static final int DAVIS_NOT_DVS = 0x80000000;
    static final int DAVIS_SPECIAL = 1 << 10;
    static final int DAVIS_ON_SHIFT = 11;
    static final int DAVIS_X_SHIFT = 12;
    static final int DAVIS_X_MASK = 0x3FF;
    static final int DAVIS_Y_SHIFT = 22;
    static final int DAVIS_Y_MASK = 0x1FF;
    static final int DAVIS_IMU = 0x80000C00;
    /** Bit 10 of an intensity sample: set for the read after the exposure, clear for the read after the reset. */
    static final int APS_SIGNAL_READ = 1 << 10;
    static final int APS_SAMPLE_MASK = 0x3FF;
    static final int IMU_CODE_SHIFT = 28;
    static final int IMU_CODE_MASK = 7;
    static final int IMU_VALUE_SHIFT = 12;
    /** Number of words in one IMU sample. Their codes 0 to 6 are acceleration x y z, temperature, gyro x y z. */
    static final int IMU_WORDS = 7;
    static final int IMU_GYRO_X = 4;

    /** Time that one overflow of the 32-bit clock adds, in µs. */
    static final long WRAP_US = 1L << 32;

    private Aedat2Format() {
    }
}
