package io.github.sofas.render;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;

import java.nio.ByteBuffer;
import java.util.Random;
import org.junit.Test;

/** What is looked up is what would be encoded. */
public class KnownPartsTest {
    private final PartTransform transform = new PartTransform(DifferenceEncoder.QUANTISATION);

    /** Codes of a part after several numbers of neighbours, and what is seen, each encoded anew. */
    private byte[] encoded(long[] part, long[] seen) {
        int[] values = new int[16];
        int[] levels = new int[16];
        PartTransform.subtract(part[0], part[2], values, 0);
        PartTransform.subtract(part[1], part[3], values, 8);
        int found = transform.quantise(values, 0, levels);
        ByteBuffer bytes = ByteBuffer.allocate(1000);
        CoefficientWriter bits = new CoefficientWriter(bytes, 0);
        for (int neighbours = 0; neighbours <= 8; neighbours++) {
            bits.writeBlock(levels, found, 0, neighbours);
        }
        bits.end();
        transform.restore(levels, found, 0, values);
        seen[0] = PartTransform.add(part[2], values, 0);
        seen[1] = PartTransform.add(part[3], values, 8);
        return bytes.array();
    }

    private static byte[] lookedUp(KnownParts known, int place) {
        ByteBuffer bytes = ByteBuffer.allocate(1000);
        CoefficientWriter bits = new CoefficientWriter(bytes, 0);
        for (int neighbours = 0; neighbours <= 8; neighbours++) {
            known.write(place, neighbours, bits);
        }
        bits.end();
        return bytes.array();
    }

    private void assertFoundAsEncoded(KnownParts known, long[][] parts) {
        known.begin();
        int[] places = new int[parts.length];
        for (int i = 0; i < parts.length; i++) {
            places[i] = known.find(i, parts[i][0], parts[i][1], parts[i][2], parts[i][3]);
        }
        for (int i = 0; i < parts.length; i++) {
            long[] expected = new long[2];
            assertArrayEquals(encoded(parts[i], expected), lookedUp(known, places[i]));
            long[] seen = new long[3];
            known.show(places[i], seen, 1);
            assertEquals(expected[0], seen[1]);
            assertEquals(expected[1], seen[2]);
        }
    }

    /** Noise takes more bits than are kept, and 20,000 blocks more places than there are. */
    @Test
    public void partsAreFoundAsTheyWouldBeEncoded() {
        Random random = new Random(8);
        KnownParts known = new KnownParts(transform);
        long[][] parts = new long[16][4];
        for (int n = 0; n < 20_000; n++) {
            for (long[] part : parts) {
                for (int i = 0; i < 4; i++) {
                    int kind = random.nextInt(4);
                    long flat = BlockPicture.word((byte) random.nextInt(9));
                    part[i] = kind == 0 ? random.nextLong() : kind == 1 ? 0 : flat;
                }
            }
            assertFoundAsEncoded(known, parts);
            // known now, but for those whose place others took
            assertFoundAsEncoded(known, parts);
        }
    }

    @Test
    public void whatIsAsPredictedHasNothingToWrite() {
        KnownParts known = new KnownParts(transform);
        known.begin();
        assertEquals(0, known.count(known.find(0, 0, 0, 0, 0)));
        assertEquals(0, known.count(known.find(1, 7, -1, 7, -1)));
        // all 16 values 100 higher: one coefficient, the mean
        assertEquals(1, known.count(known.find(2, BlockPicture.word((byte) 100), BlockPicture.word((byte) 100), 0, 0)));
    }
}
