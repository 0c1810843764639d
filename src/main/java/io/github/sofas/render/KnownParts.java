package io.github.sofas.render;

import java.nio.ByteBuffer;

/**
 * Parts of 4 x 4 values that were encoded before: what is written for them, and what the player makes of it. Dots of a
 * few colours on a ground of one make the same few thousand parts again and again: of those of brightness 95 of 100 are
 * known in a film of boxes before a panned camera, 73 in one of sixteen shapes.
 *
 * <p>A place of the table, told by all 32 values, belongs to the last part that came to it. One that is still to be
 * written with its block keeps its place: another then gets one of its own beside the table.
 */
final class KnownParts {
    private static final int PLACES = 1 << 13;
    private static final int SPREAD_SHIFT = 64 - 13;
    private static final long SPREAD = 0x9E3779B97F4A7C15L;
    /** Bits that are kept; parts that take more, which noise may, are encoded again. */
    private static final int MOST_BITS = 128;
    private static final int WORDS = 8;
    private static final int PREDICTED = 2;
    private static final int SEEN = 4;
    private static final int CODE = 6;

    private final PartTransform transform;
    /** Of each place two words as given, two as predicted, two as seen, and the code after its token. */
    private final long[] words = new long[WORDS * (PLACES + 16)];
    private final int[] tokens = new int[PLACES + 16];
    private final int[] codeBits = new int[PLACES + 16];
    /** The block that was the last to ask for a place. */
    private final int[] askedBy = new int[PLACES + 16];
    private int block;
    private final int[] values = new int[16];
    private final int[] levels = new int[16];
    private final ByteBuffer code = ByteBuffer.allocate(128);

    /** Makes a table that knows only what is as predicted. */
    KnownParts(PartTransform transform) {
        this.transform = transform;
    }

    /** Begins a block; what was found for the one before is written. */
    void begin() {
        block++;
    }

    /**
     * The place of a part, encoded.
     *
     * @param part of the block
     */
    int find(int part, long now0, long now1, long predicted0, long predicted1) {
        long spread = (((now0 * SPREAD ^ now1) * SPREAD ^ predicted0) * SPREAD ^ predicted1) * SPREAD;
        int place = (int) (spread >>> SPREAD_SHIFT);
        int at = WORDS * place;
        if (words[at] != now0 || words[at + 1] != now1 || words[at + PREDICTED] != predicted0
                || words[at + PREDICTED + 1] != predicted1) {
            if (askedBy[place] == block) {
                place = PLACES + part;
                at = WORDS * place;
            }
            words[at] = now0;
            words[at + 1] = now1;
            words[at + PREDICTED] = predicted0;
            words[at + PREDICTED + 1] = predicted1;
            encode(place, at);
        }
        askedBy[place] = block;
        return place;
    }

    private int quantise(int at) {
        PartTransform.subtract(words[at], words[at + PREDICTED], values, 0);
        PartTransform.subtract(words[at + 1], words[at + PREDICTED + 1], values, 8);
        return transform.quantise(values, 0, levels);
    }

    private void encode(int place, int at) {
        int found = quantise(at);
        tokens[place] = CoefficientWriter.token(levels, found);
        words[at + SEEN] = words[at + PREDICTED];
        words[at + SEEN + 1] = words[at + PREDICTED + 1];
        codeBits[place] = 0;
        if (found != 0) {
            code.clear();
            CoefficientWriter writer = new CoefficientWriter(code, 0);
            codeBits[place] = writer.writeLevels(levels, found);
            writer.end();
            words[at + CODE] = code.getLong(0);
            words[at + CODE + 1] = code.getLong(8);
            transform.restore(levels, found, 0, values);
            words[at + SEEN] = PartTransform.add(words[at + SEEN], values, 0);
            words[at + SEEN + 1] = PartTransform.add(words[at + SEEN + 1], values, 8);
        }
    }

    /** Coefficients that are written for a part. */
    int count(int place) {
        return tokens[place] >> 4;
    }

    /** Writes a part. */
    void write(int place, int neighbours, CoefficientWriter bits) {
        int at = WORDS * place;
        if (codeBits[place] > MOST_BITS) {
            int found = quantise(at);
            bits.writeBlock(levels, found, 0, neighbours);
        } else {
            bits.writeToken(tokens[place], neighbours);
            bits.write(words[at + CODE], words[at + CODE + 1], codeBits[place]);
        }
    }

    /** Gives a part as the player sees it. */
    void show(int place, long[] seen, int to) {
        seen[to] = words[WORDS * place + SEEN];
        seen[to + 1] = words[WORDS * place + SEEN + 1];
    }
}
