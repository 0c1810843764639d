package io.github.sofas.render;

import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;

/**
 * The time on a picture, such as {@code 12.345 s}. Its letters are drawn once and kept, because drawing letters is
 * slow.
 */
final class TimeStamp {
    private static final Font FONT = new Font(Font.MONOSPACED, Font.PLAIN, 13);
    private static final String LETTERS = "0123456789. s";

    private final BufferedImage[] letters = new BufferedImage[LETTERS.length()];
    private final int advance;
    private final int ascent;

    /** Draws the letters in a colour, as 0xRRGGBB. */
    TimeStamp(int rgb) {
        Graphics2D any = Canvas.graphics(new BufferedImage(1, 1, BufferedImage.TYPE_INT_ARGB));
        FontMetrics metrics = any.getFontMetrics(FONT);
        any.dispose();
        advance = metrics.charWidth('0');
        ascent = metrics.getAscent();
        for (int i = 0; i < letters.length; i++) {
            letters[i] = new BufferedImage(advance, ascent + metrics.getDescent(), BufferedImage.TYPE_INT_ARGB);
            Graphics2D g = Canvas.graphics(letters[i]);
            g.setFont(FONT);
            g.setColor(new Color(rgb));
            g.drawString(LETTERS.substring(i, i + 1), 0, ascent);
            g.dispose();
        }
    }

    /** The time in seconds, rounded to thousandths. */
    static String text(long timeUs) {
        long ms = (timeUs + 500) / 1000;
        return ms / 1000 + "." + Long.toString(1000 + ms % 1000).substring(1) + " s";
    }

    /**
     * Paints a time.
     *
     * @param timeUs time, at least 0, µs
     * @param right column at which the last letter ends, px
     * @param baseline row on which the letters stand, px
     */
    void paint(Canvas canvas, long timeUs, int right, int baseline) {
        String text = text(timeUs);
        Rectangle all = canvas.image().getRaster().getBounds();
        int left = right - text.length() * advance;
        for (int i = 0; i < text.length(); i++) {
            canvas.stamp(letters[LETTERS.indexOf(text.charAt(i))], left + i * advance, baseline - ascent, all);
        }
    }
}
