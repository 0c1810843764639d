package io.github.sofas.render;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.font.FontRenderContext;
import java.awt.image.BufferedImage;
import java.util.LinkedHashMap;
import java.util.Map;

/** The names that segments have in pictures. Each is drawn once and kept: letters are slow to draw. */
final class SegmentNames {
    static final int HEIGHT = 18;
    private static final int BASELINE = 14;
    private static final int PADDING = 4;
    private static final Font FONT = new Font(Font.SANS_SERIF, Font.BOLD, 13);
    private static final FontRenderContext SMOOTH = new FontRenderContext(null, true, true);
    /** Pixels about the letters. */
    private static final int HALO = 2;
    /** Most that are kept; those shown longest ago go first. */
    private static final int MOST = 256;

    private final int ground;
    /** By id, and colour in the lowest 24 bits. */
    private final Map<Long, BufferedImage> drawn = new LinkedHashMap<>(16, 0.75f, true) {
        @Override
        protected boolean removeEldestEntry(Map.Entry<Long, BufferedImage> eldest) {
            return size() > MOST;
        }
    };

    /** Makes names for pictures of a ground, as 0xRRGGBB. */
    SegmentNames(int ground) {
        this.ground = ground;
    }

    /** The name of a segment in its colour, {@link #HEIGHT} high, without background. */
    BufferedImage of(int id, int rgb) {
        long key = (long) id << 24 | rgb;
        BufferedImage name = drawn.get(key);
        if (name == null) {
            name = draw(id, rgb);
            drawn.put(key, name);
        }
        return name;
    }

    private BufferedImage draw(int id, int rgb) {
        String text = Integer.toString(id);
        int width = (int) Math.ceil(FONT.getStringBounds(text, SMOOTH).getWidth());
        BufferedImage image = new BufferedImage(width + 2 * PADDING, HEIGHT, BufferedImage.TYPE_INT_ARGB);
        Graphics2D g = PictureSheet.graphics(image);
        g.setFont(FONT);
        // else hinting makes bold letters of this size as thin as others
        g.setRenderingHint(RenderingHints.KEY_FRACTIONALMETRICS, RenderingHints.VALUE_FRACTIONALMETRICS_ON);
        // the ground's colour about the letters: a whole box would hide too much of the segment
        g.setColor(new Color(ground));
        for (int dy = -HALO; dy <= HALO; dy++) {
            for (int dx = -HALO; dx <= HALO; dx++) {
                if (dx * dx + dy * dy <= HALO * (HALO + 1)) {
                    g.drawString(text, PADDING + dx, BASELINE + dy);
                }
            }
        }
        g.setColor(new Color(rgb));
        g.drawString(text, PADDING, BASELINE);
        g.dispose();
        return image;
    }
}
