package io.github.sofas.flow.fit;

/**
 * How far a change of the motion by one unit shifts each event of a set. For a velocity, that is the time of the event
 * from the reference; for an acceleration, the square of that time, which its caller halves. Shifts are integers,
 * because shifting events is most of the work of a fit, and processors shift several at once where no number has to be
 * rounded.
 */
final class ShiftProfile {
    /** Shifts are whole numbers below 2^{@value}, and their unit is a power of two: exact to a few parts in 100,000. */
    static final int BITS = 14;
    /** A greatest shift below this counts as 0: the reciprocal of its unit would be infinite. */
    private static final float LEAST = 1e-30f;

    final int[] shift;
    private double unit;
    private int mostShift;

    ShiftProfile(int capacity) {
        shift = new int[capacity];
    }

    /** What a shift of 1 stands for. */
    double unit() {
        return unit;
    }

    /** Greatest of the shifts, rounded up. */
    int most() {
        return mostShift;
    }

    /** Takes the products of the shifts of two other profiles. */
    void takeProduct(ShiftProfile one, ShiftProfile other, int size) {
        int greatest = one.mostShift * other.mostShift;
        int down = Math.max(0, Integer.SIZE - Integer.numberOfLeadingZeros(greatest) - BITS);
        int half = 1 << down >> 1;
        unit = Math.scalb(one.unit * other.unit, down);
        mostShift = greatest + half >> down;
        int[] a = one.shift;
        int[] b = other.shift;
        int[] to = shift;
        for (int i = 0; i < size; i++) {
            to[i] = a[i] * b[i] + half >> down;
        }
    }

    /** Takes the shifts of the first {@code size} events. */
    void take(float[] values, int size) {
        float most = 0;
        for (int i = 0; i < size; i++) {
            float value = Math.abs(values[i]);
            if (value > most) {
                most = value;
            }
        }
        int exponent = Math.getExponent(most) + 1 - BITS;
        unit = most >= LEAST ? Math.scalb(1.0, exponent) : 0;
        float scale = most >= LEAST ? Math.scalb(1f, -exponent) : 0;
        mostShift = (int) Math.ceil(most * scale);
        for (int i = 0; i < size; i++) {
            // the cast rounds towards zero, so the argument is kept positive
            shift[i] = (int) (values[i] * scale + ((1 << BITS) + 0.5f)) - (1 << BITS);
        }
    }
}
