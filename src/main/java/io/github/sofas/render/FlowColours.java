package io.github.sofas.render;

/**
 * The colours of velocities. The direction selects a hue on a wheel. The speed determines how strong the hue is: at
 * rest half of the colour is the grey of events without flow, and at the speed of the full colour and above none of it.
 *
 * <p>The wheel of {@link Wheel#SAFE} goes through orange (right), violet (down), blue (left) and yellow green (up).
 * People who cannot distinguish red and green see orange and yellow green as yellowish, violet and blue as bluish. One
 * colour of each pair is lighter, so that all four directions remain distinguishable. {@link Wheel#HUE} is the circle
 * of hues that most papers use.
 */
public final class FlowColours {
    private static final int[] SAFE_DARK = {0xFF7A1A, 0xB455E8, 0x2E8BFF, 0xD2E600};
    private static final int[] SAFE_LIGHT = {0xC84B00, 0x7B2AA8, 0x1474E8, 0xB5C400};
    private static final int DIRECTIONS = 256;
    private static final int SPEEDS = 16;
    /** Direction, in steps of the table, whose tangent is i / 1024. Covers the first eighth of the turn. */
    private static final double[] EIGHTH = new double[1025];

    static {
        for (int i = 0; i < EIGHTH.length; i++) {
            EIGHTH[i] = Math.atan(i / 1024.0) / (2 * Math.PI) * DIRECTIONS;
        }
    }

    /** Colour of each direction (starting at right, turning to down) at each speed. */
    private final int[] table = new int[DIRECTIONS * (SPEEDS + 1)];

    /** The assignment of colours to directions. */
    public enum Wheel {
        /** Colours that colour-blind people can distinguish, too. */
        SAFE,
        /** The circle of hues: red is right, the others follow clockwise. */
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
     * @param theme theme of the page
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
                // never entirely grey, since slow motion has a direction, too
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

    /** The nearest direction. Taken from a table, since every pixel of every picture needs it. */
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

    /** Mixes two colours by the light that screens emit, so that the middle is not darker than both ends. */
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
