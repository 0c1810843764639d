package io.github.sofas.render;

import io.github.sofas.event.GreyFrame;

/** Stretches the contrast of frames, because the frames of cameras seldom fill the range of grey levels. */
final class GreyScale {
    private static final int LEVELS = 256;
    /** Share of the pixels that may become entirely black, and the same for white. */
    private static final double CLIPPED = 0.01;

    private GreyScale() {
    }

    /** The colour of each level of a frame, as 0xRRGGBB. */
    static int[] of(GreyFrame frame) {
        int[] counts = new int[LEVELS];
        for (byte level : frame.levels()) {
            counts[level & 0xFF]++;
        }
        int most = (int) (frame.levels().length * CLIPPED);
        int darkest = 0;
        for (int below = counts[0]; below <= most; below += counts[darkest]) {
            darkest++;
        }
        int brightest = LEVELS - 1;
        for (int above = counts[brightest]; above <= most; above += counts[brightest]) {
            brightest--;
        }
        int[] colours = new int[LEVELS];
        for (int i = 0; i < LEVELS; i++) {
            int grey = Math.min(255, Math.max(0, 255 * (i - darkest) / Math.max(1, brightest - darkest)));
            colours[i] = grey * 0x010101;
        }
        return colours;
    }
}
