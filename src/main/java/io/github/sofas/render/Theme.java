package io.github.sofas.render;

import java.util.Locale;

/** A dark or a light background, with all colours that depend on it, as 0xRRGGBB. */
public enum Theme {
    /** For screens. */
    DARK(0x15181C, 0x000000, 0xE6E8EA, 0x555B62, 0xFFB000, 0x4C9BFF,
        new int[] {0x56B4E9, 0xE69F00, 0x2FC79C, 0xF0E442, 0xBB33FF, 0xFFFFFF, 0xBB6699, 0xDD5500, 0xCCCCFF, 0x8888EE,
            0xFF8877, 0x99EEDD, 0x0044FF, 0x008800, 0x00FF00, 0xFF77FF, 0x7744BB, 0x888866, 0xFF00AA,
            0xBB0044, 0x0077BB, 0x99CC00, 0xBB00AA, 0xFFCCAA}),
    /** For paper. */
    LIGHT(0xFFFFFF, 0xF5F6F8, 0x1D2125, 0xB4BBC2, 0xC05A00, 0x0050C0,
        new int[] {0x0072B2, 0xC25500, 0x009E73, 0x9C8A00, 0x550099, 0x1D2125, 0x991155, 0x663300, 0xAA66FF, 0x1100EE,
            0xFF2255, 0x005555, 0x000000, 0xFF00DD, 0x00AAFF, 0x000077, 0x997799, 0xAA00BB, 0x7700FF,
            0x550044, 0x66BB00, 0x007700, 0xFF7700, 0x000022});

    final int page;
    final int sensor;
    final int text;
    /** Colour of events without flow. */
    final int faint;
    final int on;
    final int off;
    /**
     * Colours of segments. The first four are Okabe and Ito's, which colour-blind people can distinguish. The next
     * eight are the farthest from these, from each other and from the ground, for colour-blind people, too. The same
     * place has the same hue in both themes. After these twelve follow twelve that are the farthest from all before.
     */
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

    /**
     * {@return the colour of segments at a place, as 0xRRGGBB; places beyond the last begin again}
     *
     * @param place index of the colour, from 0
     */
    public int segmentColour(int place) {
        return segments[place % segments.length];
    }

    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }
}
