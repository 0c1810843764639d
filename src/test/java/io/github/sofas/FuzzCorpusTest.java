package io.github.sofas;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.Base64;
import java.util.Random;
import org.junit.Test;

/** A short run of every fuzz target that is the same each time: its seeds, cut short, and spoiled by chance. */
public class FuzzCorpusTest {
    private static final int SPOILED = 50;
    private static final int[] NUMBERS = {0, 1, -1, Integer.MAX_VALUE, Integer.MIN_VALUE, 1 << 16, 1 << 30, 128 << 20};

    @Test
    public void noSeedAndNoSpoiledSeedBreaksARule() {
        for (Class<?> target : FuzzTargets.ALL) {
            Random random = new Random(1);
            for (byte[] seed : FuzzTargets.seeds(target)) {
                check(target, seed);
                for (int length = 0; length < seed.length; length += 1 + seed.length / SPOILED) {
                    check(target, Arrays.copyOf(seed, length));
                }
                for (int i = 0; i < SPOILED; i++) {
                    check(target, spoiled(seed, random));
                }
            }
        }
    }

    private static void check(Class<?> target, byte[] input) {
        try {
            FuzzTargets.run(target, input);
        } catch (AssertionError e) {
            throw new AssertionError(e.getMessage() + "; input in Base64: "
                + Base64.getEncoder().encodeToString(input), e.getCause());
        }
    }

    /** One to four faults: a bit, a byte, a number, a part that is missing or comes twice. */
    private static byte[] spoiled(byte[] seed, Random random) {
        byte[] bytes = seed.clone();
        for (int faults = 1 + random.nextInt(4); faults > 0 && bytes.length > 0; faults--) {
            int at = random.nextInt(bytes.length);
            int length = Math.min(bytes.length - at, 1 + random.nextInt(40));
            switch (random.nextInt(5)) {
                case 0:
                    bytes[at] ^= (byte) (1 << random.nextInt(8));
                    break;
                case 1:
                    bytes[at] = (byte) random.nextInt();
                    break;
                case 2:
                    if (bytes.length - at >= 4) {
                        ByteOrder order = random.nextBoolean() ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN;
                        ByteBuffer.wrap(bytes).order(order).putInt(at, NUMBERS[random.nextInt(NUMBERS.length)]);
                    }
                    break;
                case 3:
                    bytes = join(Arrays.copyOf(bytes, at), Arrays.copyOfRange(bytes, at + length, bytes.length));
                    break;
                default:
                    bytes = join(Arrays.copyOf(bytes, at + length), Arrays.copyOfRange(bytes, at, bytes.length));
                    break;
            }
        }
        return bytes;
    }

    private static byte[] join(byte[] first, byte[] second) {
        byte[] both = Arrays.copyOf(first, first.length + second.length);
        System.arraycopy(second, 0, both, first.length, second.length);
        return both;
    }
}
