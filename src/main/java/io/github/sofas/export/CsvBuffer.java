package io.github.sofas.export;

import java.io.IOException;
import java.io.OutputStream;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;

/**
 * Writes numbers as ASCII text into one reused buffer, without strings, allocation or locale.
 *
 * <p>The caller reserves room once per row by {@link #makeRoom}. The single writes rely on this and do not check.
 */
final class CsvBuffer {
    private static final int CAPACITY = 1 << 17;
    /** Room behind the last row: a packed number is stored as eight bytes, whatever its length. */
    private static final int SLACK = 64;
    /** Magnitude from which a velocity is refused. Below this limit, thousandths fit a long with room to spare. */
    private static final double VELOCITY_LIMIT = 1e12;

    private static final VarHandle LONGS = MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.LITTLE_ENDIAN);

    /**
     * The digits of 0 to 999 with leading zeros, three bytes each, first digit in the lowest byte. The fourth byte is a
     * comma.
     */
    private static final int[] THREE_DIGITS = threeDigits();
    /**
     * The text of each number from 0 to 4095 and a comma, first character in the lowest byte. The highest byte is the
     * length of this text.
     */
    private static final long[] SMALL = smallNumbers();

    private final OutputStream out;
    final byte[] bytes = new byte[CAPACITY + SLACK];
    int size;

    CsvBuffer(OutputStream out) {
        this.out = out;
    }

    private static int[] threeDigits() {
        int[] table = new int[1000];
        for (int i = 0; i < 1000; i++) {
            table[i] = '0' + i / 100 | '0' + i / 10 % 10 << 8 | '0' + i % 10 << 16 | ',' << 24;
        }
        return table;
    }

    private static long[] smallNumbers() {
        long[] table = new long[4096];
        for (int i = 0; i < table.length; i++) {
            String text = i + ",";
            long packed = (long) text.length() << 56;
            for (int k = 0; k < text.length(); k++) {
                packed |= (long) text.charAt(k) << 8 * k;
            }
            table[i] = packed;
        }
        return table;
    }

    /** Writes out the buffer if fewer than {@code length} bytes are free. */
    void makeRoom(int length) throws IOException {
        if (size + length > CAPACITY) {
            flush();
        }
    }

    void flush() throws IOException {
        out.write(bytes, 0, size);
        size = 0;
    }

    void put(char ascii) {
        bytes[size++] = (byte) ascii;
    }

    void put(byte[] source, int from, int length) {
        System.arraycopy(source, from, bytes, size, length);
        size += length;
    }

    void put(String ascii) {
        for (int i = 0; i < ascii.length(); i++) {
            bytes[size++] = (byte) ascii.charAt(i);
        }
    }

    /** Puts a whole number and a comma. */
    void putWithComma(int number) {
        if ((number & ~4095) == 0) {
            long packed = SMALL[number];
            LONGS.set(bytes, size, packed);
            size += (int) (packed >>> 56);
        } else {
            put((long) number);
            put(',');
        }
    }

    /** Puts the last three digits of a number and a comma. The digits before them must already be in the buffer. */
    void putThreeDigitsWithComma(int number) {
        int packed = THREE_DIGITS[number];
        bytes[size] = (byte) packed;
        bytes[size + 1] = (byte) (packed >>> 8);
        bytes[size + 2] = (byte) (packed >>> 16);
        bytes[size + 3] = ',';
        size += 4;
    }

    /** Puts a whole number. */
    void put(long number) {
        if (number < 0) {
            if (number == Long.MIN_VALUE) {
                put(Long.toString(number));
                return;
            }
            put('-');
            number = -number;
        }
        putDigits(number);
    }

    private void putDigits(long number) {
        if (number < 1000) {
            putLeadingDigits((int) number);
            return;
        }
        long thousands = number / 1000;
        putDigits(thousands);
        putThreeDigitsWithComma((int) (number - thousands * 1000));
        size--;
    }

    private void putLeadingDigits(int number) {
        int packed = THREE_DIGITS[number];
        if (number >= 100) {
            bytes[size++] = (byte) packed;
        }
        if (number >= 10) {
            bytes[size++] = (byte) (packed >>> 8);
        }
        bytes[size++] = (byte) (packed >>> 16);
    }

    /**
     * Puts a velocity with three decimals, rounded half away from zero; never "-0.000". The rounding is that of
     * {@code new BigDecimal(velocity).setScale(3, RoundingMode.HALF_UP)}. A float has 24 significant bits, and 1000 has
     * seven without its trailing zeros, so their product as a double is exact. {@link Math#round} of a positive double
     * is half up.
     *
     * @throws IllegalArgumentException if the velocity is not finite or its magnitude is 1e12 or more
     */
    void putVelocity(float velocity) {
        double magnitude = Math.abs((double) velocity);
        if (!(magnitude < VELOCITY_LIMIT)) {
            throw new IllegalArgumentException("velocity must be smaller than 1e12 px/s but was " + velocity);
        }
        long thousandths = Math.round(magnitude * 1000);
        if (velocity < 0 && thousandths != 0) {
            put('-');
        }
        long whole = thousandths / 1000;
        putDigits(whole);
        put('.');
        putThreeDigitsWithComma((int) (thousandths - whole * 1000));
        size--;
    }
}
