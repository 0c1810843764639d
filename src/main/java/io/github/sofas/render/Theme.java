package io.github.sofas.render;

import java.util.Locale;

/** Dark or light background, with all colours that depend on it, as 0xRRGGBB. */
public enum Theme {
    /** For screens. */
    DARK(0x15181C, 0x000000, 0xE6E8EA, 0x555B62, 0xFFB000, 0x4C9BFF,
        new int[] {0x56B4E9, 0xE69F00, 0x2FC79C, 0xF0E442, 0xFF8A4C, 0xE39BCB, 0xFFFFFF, 0x8C7BFF, 0xA6D854, 0xC49A6C,
            0x00D7E0, 0xFF5C8A}),
    /** For paper. */
    LIGHT(0xFFFFFF, 0xF5F6F8, 0x1D2125, 0xB4BBC2, 0xC05A00, 0x0050C0,
        new int[] {0x0072B2, 0xD55E00, 0x009E73, 0xB0559A, 0x8A6D00, 0x2E9AD0, 0x1D2125, 0x5B3FD0, 0x5B8C00, 0x7A4B1E,
            0x007C85, 0xC2185B});

    final int page;
    final int sensor;
    final int text;
    /** Events without flow. */
    final int faint;
    final int on;
    final int off;
    /** Colours of segments: those of Okabe and Ito first, which colour-blind people tell apart, then more. */
    final int[] segments;

    Theme(int page, int sensor, int text, int faint, int on, int off, int[] segments) {
        this.page = page;
        this.sensor = sensor;
        this.text = text;
        this.faint = faint;
        this.on = on;
        this.off = off;
        this.segments = segments;
    }

    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }
}
