package io.github.sofas.render;

import java.nio.ByteBuffer;
import java.util.function.IntUnaryOperator;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.jcodec.codecs.h264.H264Const;
import org.jcodec.codecs.h264.decode.CoeffTransformer;
import org.jcodec.common.io.BitWriter;
import org.jcodec.common.io.VLC;

/**
 * Writes the numbers of H.264's pictures: Golomb codes, and coefficients in the variable-length code that depends on
 * the blocks left and above (CAVLC; ITU-T H.264, 9.1 and 9.2). The codes are jcodec's; its own writer, which allocates
 * for each block and goes through a buffer code by code, takes several times as long.
 */
final class CoefficientWriter {
    /** Places of a block's coefficients in the order in which they are written. */
    static final int[] SCAN = CoeffTransformer.zigzag4x4;

    private static final int MOST_SUFFIX_BITS = 6;
    /** Zeros before a level that is written as it is, and its bits. */
    private static final int ESCAPE = 15;
    private static final int ESCAPED_BITS = 12;
    /** Codes, 16 bits of them below their length; by what they depend on, then by what they say. */
    private static final int[][] TOKENS = Stream.of(H264Const.CoeffToken).limit(9).map(codes -> tokens(codes, 16))
        .toArray(int[][]::new);
    private static final int[] COLOUR_TOKENS = tokens(H264Const.coeffTokenChromaDCY420, 4);
    private static final int[][] ZEROS = codes(H264Const.totalZeros16);
    private static final int[][] COLOUR_ZEROS = codes(H264Const.totalZeros4);
    private static final int[][] RUNS = codes(H264Const.run);
    /** Codes of levels up to 127, beyond which only the means of whole pictures are; by bits of suffix. */
    private static final int[][] LEVELS = new int[MOST_SUFFIX_BITS + 1][256];

    static {
        for (int suffixBits = 0; suffixBits <= MOST_SUFFIX_BITS; suffixBits++) {
            for (int number = 0; number < LEVELS[suffixBits].length; number++) {
                LEVELS[suffixBits][number] = levelCode(number, suffixBits);
            }
        }
    }

    private final int[] levels = new int[16];
    private final int[] places = new int[16];
    private final ByteBuffer out;
    /** Bits that are not written yet, the last one lowest. */
    private long waiting;
    private int waitingBits;

    /** Goes on in a buffer, after as many bits from its beginning. */
    CoefficientWriter(ByteBuffer out, int bits) {
        this.out = out;
        out.position(bits / Byte.SIZE);
        waitingBits = bits % Byte.SIZE;
        waiting = waitingBits == 0 ? 0 : (out.get(out.position()) & 0xFF) >>> Byte.SIZE - waitingBits;
    }

    private static int[] tokens(VLC codes, int mostCoefficients) {
        return codes(codes, H264Const.coeffToken(mostCoefficients, 3) + 1, token -> {
            int ones = token & 15;
            return ones > 3 || ones > token >> 4 ? -1 : token;
        });
    }

    private static int[][] codes(VLC[] codes) {
        return Stream.of(codes).map(each -> codes(each, each.getCodes().length, value -> value)).toArray(int[][]::new);
    }

    private static int[] codes(VLC codes, int size, IntUnaryOperator valueOrNone) {
        return IntStream.range(0, size).map(valueOrNone).map(value -> value < 0 ? 0 : code(codes, value)).toArray();
    }

    private static int code(VLC codes, int value) {
        ByteBuffer bytes = ByteBuffer.allocate(4);
        BitWriter bits = new BitWriter(bytes);
        codes.writeVLC(bits, value);
        int length = bits.position();
        bits.flush();
        return length << 16 | bytes.getInt(0) >>> 32 - length;
    }

    private void write(int code) {
        write(code & 0xFFFFL, code >>> 16);
    }

    /** Writes the lowest bits of a value, 32 at most; the others must be 0. */
    private void write(long value, int bits) {
        waiting = waiting << bits | value;
        waitingBits += bits;
        if (waitingBits >= Integer.SIZE) {
            waitingBits -= Integer.SIZE;
            out.putInt((int) (waiting >>> waitingBits));
        }
    }

    /** Writes up to 128 bits, of which the first is the highest of the first word. */
    void write(long first, long second, int bits) {
        long word = first;
        int rest = bits;
        if (rest > Long.SIZE) {
            write(word >>> Integer.SIZE, Integer.SIZE);
            write(word & 0xFFFF_FFFFL, Integer.SIZE);
            word = second;
            rest -= Long.SIZE;
        }
        if (rest > Integer.SIZE) {
            write(word >>> Integer.SIZE, Integer.SIZE);
            word <<= Integer.SIZE;
            rest -= Integer.SIZE;
        }
        if (rest > 0) {
            write(word >>> Long.SIZE - rest, rest);
        }
    }

    /** Writes a number from 0 up. */
    void writeUnsigned(int value) {
        write(value + 1, 2 * (Integer.SIZE - Integer.numberOfLeadingZeros(value + 1)) - 1);
    }

    /** Writes a number of either sign. */
    void writeSigned(int value) {
        writeUnsigned(value > 0 ? 2 * value - 1 : -2 * value);
    }

    /** Writes what is still waiting, after a 1 that ends the slice. */
    void end() {
        write(1L, 1);
        for (; waitingBits > 0; waitingBits -= Byte.SIZE) {
            out.put((byte) (waitingBits >= Byte.SIZE ? waiting >>> waitingBits - Byte.SIZE
                : waiting << Byte.SIZE - waitingBits));
        }
        waitingBits = 0;
    }

    /**
     * Writes a block of 4 x 4 coefficients.
     *
     * @param levels them in the order of {@link #SCAN}
     * @param found which of them are not zero, as bits
     * @param first 0, or 1 where the first coefficient is written elsewhere
     * @param neighbours the mean of the coefficients that the blocks left and above have
     */
    void writeBlock(int[] levels, int found, int first, int neighbours) {
        writeToken(token(levels, found), neighbours);
        writeLevels(levels, found, first, 16, ZEROS);
    }

    /** Writes the four coefficients that stand for the mean colours of a macroblock. */
    void writeColourMeans(int[] means) {
        int found = 0;
        for (int i = 0; i < 4; i++) {
            found |= means[i] == 0 ? 0 : 1 << i;
        }
        write(COLOUR_TOKENS[token(means, found)]);
        writeLevels(means, found, 0, 4, COLOUR_ZEROS);
    }

    /**
     * What a block's code begins with: how many coefficients it has, times 16, and how many ones end them, up to three.
     *
     * @param found which of the levels are not zero, as bits
     */
    static int token(int[] levels, int found) {
        int rest = found;
        int ones = 0;
        while (rest != 0 && ones < 3 && Math.abs(levels[highest(rest)]) == 1) {
            rest ^= 1 << highest(rest);
            ones++;
        }
        return H264Const.coeffToken(Integer.bitCount(found), ones);
    }

    private static int highest(int bits) {
        return Integer.SIZE - 1 - Integer.numberOfLeadingZeros(bits);
    }

    /** Writes how a block begins; the one part of its code that depends on others. */
    void writeToken(int token, int neighbours) {
        write(TOKENS[Math.min(neighbours, 8)][token]);
    }

    /** Writes what follows the token of a block whose first coefficient is not written elsewhere; how many bits. */
    int writeLevels(int[] levels, int found) {
        int before = out.position() * Byte.SIZE + waitingBits;
        writeLevels(levels, found, 0, 16, ZEROS);
        return out.position() * Byte.SIZE + waitingBits - before;
    }

    private void writeLevels(int[] values, int found, int first, int end, int[][] zeroCodes) {
        int count = 0;
        for (int rest = found; rest != 0; rest &= rest - 1) {
            places[count] = Integer.numberOfTrailingZeros(rest);
            levels[count] = values[places[count]];
            count++;
        }
        if (count == 0) {
            return;
        }
        int ones = 0;
        int signs = 0;
        while (ones < Math.min(3, count) && Math.abs(levels[count - 1 - ones]) == 1) {
            signs = signs << 1 | levels[count - 1 - ones] >>> 31;
            ones++;
        }
        write(signs, ones);
        writeLevels(count, ones);
        int zeros = places[count - 1] - first - (count - 1);
        if (count < end - first) {
            write(zeroCodes[count - 1][zeros]);
        }
        for (int i = count - 1; i > 0 && zeros > 0; i--) {
            int run = places[i] - places[i - 1] - 1;
            write(RUNS[Math.min(zeros, RUNS.length) - 1][run]);
            zeros -= run;
        }
    }

    /** From the highest coefficient down; a level's code has more bits where the one before was large. */
    private void writeLevels(int count, int ones) {
        int suffixBits = count > 10 && ones < 3 ? 1 : 0;
        // the first of fewer than three ones is none
        int less = ones < 3 ? 4 : 2;
        for (int i = count - 1 - ones; i >= 0; i--) {
            int magnitude = Math.abs(levels[i]);
            int number = 2 * magnitude + (levels[i] >>> 31) - less;
            write(number < LEVELS[0].length ? LEVELS[suffixBits][number] : levelCode(number, suffixBits));
            less = 2;
            suffixBits = Math.max(suffixBits, 1);
            suffixBits += magnitude > 3 << suffixBits - 1 && suffixBits < MOST_SUFFIX_BITS ? 1 : 0;
        }
    }

    /** The code of a level, of a number that has its sign as last bit. */
    private static int levelCode(int number, int suffixBits) {
        int escapeAt = suffixBits == 0 ? 30 : ESCAPE << suffixBits;
        if (number >= escapeAt) {
            return ESCAPE + 1 + ESCAPED_BITS << 16 | 1 << ESCAPED_BITS | number - escapeAt;
        }
        if (suffixBits == 0 && number >= 14) {
            return 15 + 4 << 16 | 1 << 4 | number - 14;
        }
        return (number >> suffixBits) + 1 + suffixBits << 16 | 1 << suffixBits | number & (1 << suffixBits) - 1;
    }
}
