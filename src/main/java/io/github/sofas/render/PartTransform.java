package io.github.sofas.render;

import java.util.Arrays;
import org.jcodec.codecs.h264.decode.CoeffTransformer;

/**
 * Turns differences of 4 x 4 values into counted coefficients and back, at one coarseness. The transforms are jcodec's;
 * it quantises all of a part's coefficients in several passes, of which most are zero.
 */
final class PartTransform {
    final int quantisation;
    /** Coefficient by coefficient in the order in which they are written: what a step is, and what to divide by it. */
    private final int[] steps = new int[16];
    private final int[] factors = new int[16];
    private final int addition;
    private final int shift;

    /** Prepares for a coarseness, 0 to 51. */
    PartTransform(int quantisation) {
        this.quantisation = quantisation;
        int[] byPlace = new int[16];
        Arrays.fill(byPlace, 1);
        CoeffTransformer.dequantizeAC(byPlace, quantisation, null);
        shift = 15 + quantisation / 6;
        // thirds of a step and more count as one
        addition = (1 << shift) / 3;
        for (int i = 0; i < 16; i++) {
            int place = CoefficientWriter.SCAN[i];
            steps[i] = byPlace[place];
            // jcodec's forward transform is longer along odd rows and columns than its inverse
            double length = ((place & 1) == 0 ? 1 : 0.8) * ((place >> 2 & 1) == 0 ? 1 : 0.8);
            factors[i] = (int) Math.round((4 << shift) * length / steps[i]);
        }
    }

    /**
     * Takes eight values, half a part, from others.
     *
     * @param part gets the differences, from a place on
     * @return the greatest of them, without sign
     */
    static int subtract(long now, long predicted, int[] part, int from) {
        int greatest = 0;
        for (int i = 0; i < 8; i++) {
            int difference = (byte) (now >>> 8 * i) - (byte) (predicted >>> 8 * i);
            part[from + i] = difference;
            greatest = Math.max(greatest, Math.abs(difference));
        }
        return greatest;
    }

    /** Adds differences, from a place on, to eight values, as far as these reach. */
    static long add(long predicted, int[] part, int from) {
        long sum = 0;
        for (int i = 0; i < 8; i++) {
            int value = (byte) (predicted >>> 8 * i) + part[from + i];
            sum |= (Math.max(-128, Math.min(127, value)) & 0xFFL) << 8 * i;
        }
        return sum;
    }

    /**
     * Transforms differences into coefficients and counts these in steps.
     *
     * @param part differences, then coefficients
     * @param first 0, or 1 where the first coefficient is counted elsewhere
     * @param levels gets them in the order of {@link CoefficientWriter#SCAN}
     * @return which of them are not zero, as bits
     */
    int quantise(int[] part, int first, int[] levels) {
        CoeffTransformer.fdct4x4(part);
        int found = 0;
        for (int i = first; i < 16; i++) {
            int coefficient = part[CoefficientWriter.SCAN[i]];
            int sign = coefficient >> 31;
            int level = ((coefficient ^ sign) - sign) * factors[i] + addition >> shift;
            levels[i] = (level ^ sign) - sign;
            found |= -level >>> 31 << i;
        }
        return found;
    }

    /** Makes differences of what was counted, and of a first coefficient that was counted elsewhere, as players do. */
    void restore(int[] levels, int found, int mean, int[] part) {
        Arrays.fill(part, 0);
        part[0] = mean;
        for (int rest = found; rest != 0; rest &= rest - 1) {
            int i = Integer.numberOfTrailingZeros(rest);
            part[CoefficientWriter.SCAN[i]] = levels[i] * steps[i];
        }
        CoeffTransformer.idct4x4(part);
    }
}
