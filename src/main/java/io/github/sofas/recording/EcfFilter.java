package io.github.sofas.recording;

import io.jhdf.exceptions.HdfFilterException;
import io.jhdf.filter.Filter;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;

/**
 * Unpacks chunks of events in Prophesee's codec ECF (filter 36559) into structures of 16 bytes: two bytes each for x, y
 * and polarity, two unused bytes, and eight for the time in µs. Safe for many threads.
 *
 * <p>A chunk starts with a word with the number of events and two flags, the first time, and runs of equal times. The
 * flags select how the rest is packed. Either y, x and polarity of each event share 24 bits, or runs of equal rows
 * follow. After these rows, either x and polarity share 12 bits, or each column has a mask of the five to its right,
 * and runs of equal polarities follow.
 *
 * <p>Source: prophesee-ai/hdf5_ecf. Own code because no library for Java supports the codec.
 */
final class EcfFilter implements Filter {
    private static final int ID = 36559;
    private static final int EVENT_BYTES = 16;
    private static final int TIME_AT = 8;
    private static final int Y_AT = 2;
    private static final int POLARITY_AT = 4;
    private static final int MOST_EVENTS = 65_535;
    private static final int ALL_PACKED = 2;
    private static final int COLUMNS_PACKED = 1;
    private static final int NEIGHBOURS = 5;

    private static final VarHandle SHORT = MethodHandles.byteArrayViewVarHandle(short[].class, ByteOrder.LITTLE_ENDIAN);
    private static final VarHandle INT = MethodHandles.byteArrayViewVarHandle(int[].class, ByteOrder.LITTLE_ENDIAN);
    private static final VarHandle LONG = MethodHandles.byteArrayViewVarHandle(long[].class, ByteOrder.LITTLE_ENDIAN);

    @Override
    public int getId() {
        return ID;
    }

    @Override
    public String getName() {
        return "ecf";
    }

    @Override
    public byte[] decode(byte[] packed, int[] settings) {
        return new Chunk(packed).unpack();
    }

    /** A chunk that is being unpacked. */
    private static final class Chunk {
        private final byte[] packed;
        private final int count;
        private final byte[] events;
        private int p = Integer.BYTES;

        Chunk(byte[] packed) {
            this.packed = packed;
            check(packed.length >= Integer.BYTES, "a chunk must have a header");
            count = (int) INT.get(packed, 0) >>> 2;
            check(count <= MOST_EVENTS, "a chunk must have at most " + MOST_EVENTS + " events");
            events = new byte[count * EVENT_BYTES];
        }

        byte[] unpack() {
            int flags = (int) INT.get(packed, 0);
            times();
            if ((flags & ALL_PACKED) != 0) {
                rowsColumnsAndPolarities();
            } else {
                rows();
                if ((flags & COLUMNS_PACKED) != 0) {
                    columnsAndPolarities();
                } else {
                    maskedColumns();
                    polarities();
                }
            }
            return events;
        }

        private int nextByte() {
            check(p < packed.length, "a chunk must be whole");
            return packed[p++] & 0xFF;
        }

        private int nextShort() {
            check(p + Short.BYTES <= packed.length, "a chunk must be whole");
            int value = (short) SHORT.get(packed, p) & 0xFFFF;
            p += Short.BYTES;
            return value;
        }

        private int nextInt() {
            check(p + Integer.BYTES <= packed.length, "a chunk must be whole");
            int value = (int) INT.get(packed, p);
            p += Integer.BYTES;
            return value;
        }

        private void checkRun(int i, int length) {
            check(length <= count - i, "a run of equal values must end within its chunk");
        }

        /**
         * Reads the times. A byte holds a step of time below 15 and a count of events; a step of 15 begins a longer
         * step, in parts of four bits.
         */
        private void times() {
            check(p + Long.BYTES <= packed.length, "a chunk must be whole");
            long time = (long) LONG.get(packed, p);
            p += Long.BYTES;
            for (int i = 0; i < count;) {
                int value = nextByte();
                if (value >>> 4 == 0xF) {
                    long step = 0;
                    for (int shift = 0; value >>> 4 == 0xF; shift += 4) {
                        check(shift < Long.SIZE, "a step of time must have at most 64 bits");
                        step |= (long) (value & 0xF) << shift;
                        value = nextByte();
                    }
                    p--;
                    time += step;
                    continue;
                }
                time += value >>> 4;
                int length = value & 0xF;
                if (length == 0xF) {
                    length = nextByte() | nextByte() << Byte.SIZE;
                }
                checkRun(i, length);
                for (int end = i + length; i < end; i++) {
                    LONG.set(events, i * EVENT_BYTES + TIME_AT, time);
                }
            }
        }

        private void rows() {
            for (int i = 0; i < count;) {
                int value = nextShort();
                int length = value & 0x1F;
                if (length == 0x1F) {
                    length = nextShort();
                }
                checkRun(i, length);
                for (int end = i + length; i < end; i++) {
                    SHORT.set(events, i * EVENT_BYTES + Y_AT, (short) (value >>> 5));
                }
            }
        }

        private void polarities() {
            for (int i = 0; i < count;) {
                int value = nextByte();
                int length = value & 0x7F;
                if (length == 0x7F) {
                    length = nextByte() | nextByte() << Byte.SIZE;
                }
                checkRun(i, length);
                for (int end = i + length; i < end; i++) {
                    SHORT.set(events, i * EVENT_BYTES + POLARITY_AT, (short) (value >>> 7));
                }
            }
        }

        private void maskedColumns() {
            for (int i = 0; i < count;) {
                int value = nextShort();
                int column = value >>> 5;
                SHORT.set(events, i++ * EVENT_BYTES, (short) column);
                for (int k = 1; k <= NEIGHBOURS; k++) {
                    // the encoder may set bits for columns after the last event
                    if ((value >>> NEIGHBOURS - k & 1) != 0 && i < count) {
                        SHORT.set(events, i++ * EVENT_BYTES, (short) (column + k));
                    }
                }
            }
        }

        /** Four values of 12 bits each lie in three numbers of 16 bits. */
        private void columnsAndPolarities() {
            for (int i = 0; i < count; i += 4) {
                int a = nextShort();
                int b = nextShort();
                int c = nextShort();
                columnAndPolarity(i, a >>> 4);
                columnAndPolarity(i + 1, a & 0xF | b >>> 8 << 4);
                columnAndPolarity(i + 2, b & 0xFF | c >>> 12 << 8);
                columnAndPolarity(i + 3, c & 0xFFF);
            }
        }

        /** Four values of 24 bits each lie in three numbers of 32 bits. */
        private void rowsColumnsAndPolarities() {
            for (int i = 0; i < count; i += 4) {
                int a = nextInt();
                int b = nextInt();
                int c = nextInt();
                rowColumnAndPolarity(i, a >>> 8);
                rowColumnAndPolarity(i + 1, a & 0xFF | b >>> 16 << 8);
                rowColumnAndPolarity(i + 2, b & 0xFFFF | c >>> 24 << 16);
                rowColumnAndPolarity(i + 3, c & 0xFFFFFF);
            }
        }

        private void rowColumnAndPolarity(int i, int value) {
            columnAndPolarity(i, value & 0xFFF);
            if (i < count) {
                SHORT.set(events, i * EVENT_BYTES + Y_AT, (short) (value >>> 12 & 0x7FF));
            }
        }

        /** Stores an event's values; places after the last event only fill its group of four. */
        private void columnAndPolarity(int i, int value) {
            if (i < count) {
                SHORT.set(events, i * EVENT_BYTES, (short) (value >>> 1));
                SHORT.set(events, i * EVENT_BYTES + POLARITY_AT, (short) (value & 1));
            }
        }

        private static void check(boolean holds, String rule) {
            if (!holds) {
                throw new HdfFilterException("ECF: " + rule);
            }
        }
    }
}
