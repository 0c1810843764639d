package io.github.sofas.render;

/**
 * The colour of a velocity: its direction round a wheel, from the background's grey at rest to full colour at the
 * greatest speed and above.
 *
 * <p>The wheel of {@link Wheel#SAFE} goes through orange (right), violet (down), blue (left) and yellow green (up).
 * Orange and yellow green stay yellowish, violet and blue stay bluish to people who cannot distinguish red and green,
 * and in each pair one is lighter, so that all four directions stay apart. {@link Wheel#HUE} is the circle of hues that
 * most papers use.
 */
public final class FlowColours {
    private static final int[] SAFE_DARK = {0xFF7A1A, 0xB455E8, 0x2E8BFF, 0xD2E600};
    private static final int[] SAFE_LIGHT = {0xC84B00, 0x7B2AA8, 0x1474E8, 0xB5C400};
    private static final int DIRECTIONS = 256;
    private static final int SPEEDS = 16;
    /** Direction, in steps, whose tangent is i / 1024: the first eighth of the turn. */
    private static final double[] EIGHTH = new double[1025];

    static {
        for (int i = 0; i < EIGHTH.length; i++) {
            EIGHTH[i] = Math.atan(i / 1024.0) / (2 * Math.PI) * DIRECTIONS;
        }
    }

    /** Colour of each direction, from right to down, at each speed. */
    private final int[] table = new int[DIRECTIONS * (SPEEDS + 1)];

    /** Which colours stand for which direction. */
    public enum Wheel {
        /** Told apart by colour-blind people too. */
        SAFE,
        /** The circle of hues: red right, then with the hands of a clock. */
        HUE;

        @Override
        public String toString() {
            return name().toLowerCase(java.util.Locale.ROOT);
        }
    }

    /**
     * Makes the colours of a wheel on a theme's background.
     *
     * @param wheel colours of the directions
     * @param theme of the page
     */
    public FlowColours(Wheel wheel, Theme theme) {
        int[] anchors = theme == Theme.DARK ? SAFE_DARK : SAFE_LIGHT;
        for (int d = 0; d < DIRECTIONS; d++) {
            int full;
            if (wheel == Wheel.HUE) {
                full = java.awt.Color.HSBtoRGB((float) d / DIRECTIONS, 1, theme == Theme.DARK ? 1 : 0.8f) & 0xFFFFFF;
            } else {
                double at = d * 4.0 / DIRECTIONS;
                int from = (int) at;
                full = mix(anchors[from], anchors[(from + 1) % 4], at - from);
            }
            for (int s = 0; s <= SPEEDS; s++) {
                // never wholly grey: slow motion has a direction too
                table[d * (SPEEDS + 1) + s] = mix(theme.faint, full, 0.5 + 0.5 * s / SPEEDS);
            }
        }
    }

    /**
     * {@return the colour of a velocity as 0xRRGGBB}
     *
     * @param vxPxPerS velocity to the right in px/s
     * @param vyPxPerS velocity downwards in px/s
     * @param fullPxPerS speed of the full colour
     */
    public int rgb(double vxPxPerS, double vyPxPerS, double fullPxPerS) {
        int d = direction(vxPxPerS, vyPxPerS);
        double speed = Math.sqrt(vxPxPerS * vxPxPerS + vyPxPerS * vyPxPerS);
        int s = (int) Math.min(SPEEDS, Math.round(speed / fullPxPerS * SPEEDS));
        return table[d * (SPEEDS + 1) + s];
    }

    /** The nearest direction; by a table, as every pixel of every picture asks. */
    private static int direction(double vx, double vy) {
        double x = Math.abs(vx);
        double y = Math.abs(vy);
        double most = Math.max(x, y);
        double d = most == 0 ? 0 : EIGHTH[(int) (Math.min(x, y) / most * (EIGHTH.length - 1) + 0.5)];
        d = y > x ? DIRECTIONS / 4 - d : d;
        d = vx < 0 ? DIRECTIONS / 2 - d : d;
        d = vy < 0 ? DIRECTIONS - d : d;
        return (int) (d + 0.5) & DIRECTIONS - 1;
    }

    /** Mixes in light as screens emit it, so that halfway is not darker than both ends. */
    static int mix(int a, int b, double share) {
        int rgb = 0;
        for (int shift = 0; shift <= 16; shift += 8) {
            double from = a >> shift & 0xFF;
            double to = b >> shift & 0xFF;
            rgb |= (int) Math.round(Math.sqrt(from * from * (1 - share) + to * to * share)) << shift;
        }
        return rgb;
    }
}
