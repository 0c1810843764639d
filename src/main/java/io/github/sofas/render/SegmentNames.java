package io.github.sofas.render;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.font.FontRenderContext;
import java.awt.image.BufferedImage;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * Draws the names of segments, which are their ids. Each name is drawn once and kept, because drawing letters is slow.
 */
final class SegmentNames {
    static final int HEIGHT = 18;
    private static final int BASELINE = 14;
    private static final int PADDING = 4;
    private static final Font FONT = new Font(Font.SANS_SERIF, Font.BOLD, 13);
    private static final FontRenderContext SMOOTH = new FontRenderContext(null, true, true);
    private static final int ROUND = 8;
    /** Most names that are kept; the least recently used go first. */
    private static final int MOST = 256;

    private final int ground;
    private final int outline;
    /** The names, by a key of the id and, in the lowest 24 bits, the colour. */
    private final Map<Long, BufferedImage> drawn = new LinkedHashMap<>(16, 0.75f, true) {
        @Override
        protected boolean removeEldestEntry(Map.Entry<Long, BufferedImage> eldest) {
            return size() > MOST;
        }
    };

    /** Makes names for pictures with a ground and an outline of these colours, both as 0xRRGGBB. */
    SegmentNames(int ground, int outline) {
        this.ground = ground;
        this.outline = outline;
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
        Graphics2D g = Canvas.graphics(image);
        g.setFont(FONT);
        // without this, hinting makes bold letters of this size as thin as others
        g.setRenderingHint(RenderingHints.KEY_FRACTIONALMETRICS, RenderingHints.VALUE_FRACTIONALMETRICS_ON);
        // a name in its own colour would be lost on events of that colour, so the colour is the ground of the letters
        g.setColor(new Color(outline));
        g.fillRoundRect(0, 0, image.getWidth(), HEIGHT, ROUND, ROUND);
        g.setColor(new Color(rgb));
        g.fillRoundRect(1, 1, image.getWidth() - 2, HEIGHT - 2, ROUND - 2, ROUND - 2);
        boolean isBright = SegmentColours.difference(rgb, ground) > SegmentColours.difference(rgb, outline);
        g.setColor(new Color(isBright ? ground : outline));
        g.drawString(text, PADDING, BASELINE);
        g.dispose();
        return image;
    }
}
