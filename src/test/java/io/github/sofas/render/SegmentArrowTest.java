package io.github.sofas.render;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.util.List;
import org.junit.Test;

/** A panel of 200 x 150 px in a picture with at least 50 px more on each side. */
public class SegmentArrowTest {
    private static final Rectangle PANEL = new Rectangle(50, 50, 200, 150);
    private static final int RED = 0xFF0000;
    private static final int BLUE = 0x0000FF;

    private static BufferedImage paint(SegmentArrow... arrows) {
        Canvas canvas = new Canvas(304, 256);
        SegmentArrow.paint(canvas, PANEL, List.of(arrows), Theme.DARK, new SegmentNames(0x000000, 0xE6E8EA));
        return canvas.image();
    }

    private static Rectangle box(BufferedImage picture, int rgb) {
        Rectangle box = new Rectangle(0, 0, -1, -1);
        for (int y = 0; y < picture.getHeight(); y++) {
            for (int x = 0; x < picture.getWidth(); x++) {
                if ((picture.getRGB(x, y) & 0xFFFFFF) == rgb) {
                    box.add(new Rectangle(x, y, 1, 1));
                }
            }
        }
        return box;
    }

    @Test
    public void arrowPointsFromTheCentreAlongTheVelocity() {
        Rectangle box = box(paint(new SegmentArrow(1, RED, 50, 120, 100, 60, 0)), RED);
        assertTrue(box.toString(), Math.abs(box.getMaxX() - 180) <= 3);
        // the name behind the tail, 14 px further left, is about 9 px wide
        assertTrue(box.toString(), Math.abs(box.getMinX() - (120 - 14 - 4)) <= 4);
    }

    @Test
    public void arrowsAndNamesStayInThePanel() {
        for (int[] corner : new int[][] {{51, 51}, {249, 51}, {51, 199}, {249, 199}}) {
            for (int turn = 0; turn < 8; turn++) {
                Rectangle box = box(paint(new SegmentArrow(1234, RED, 50, corner[0], corner[1],
                    80 * Math.cos(turn * Math.PI / 4), 80 * Math.sin(turn * Math.PI / 4))), RED);
                assertTrue(box.toString(), PANEL.contains(box));
                double length = Math.max(box.getWidth(), box.getHeight());
                assertTrue("not cut: " + box, length >= 80 * Math.sqrt(0.5));
            }
        }
    }

    @Test
    public void namesDoNotHideEachOther() {
        BufferedImage alone = paint(new SegmentArrow(22, BLUE, 40, 150, 125, 0, 0));
        BufferedImage both = paint(new SegmentArrow(11, RED, 50, 150, 125, 0, 0),
            new SegmentArrow(22, BLUE, 40, 150, 125, 0, 0));
        assertEquals(count(alone, BLUE), count(both, BLUE), 12);
        assertTrue(count(both, RED) > 10);
    }

    private static int count(BufferedImage picture, int rgb) {
        int count = 0;
        for (int pixel : picture.getRGB(0, 0, 304, 256, null, 0, 304)) {
            count += (pixel & 0xFFFFFF) == rgb ? 1 : 0;
        }
        return count;
    }
}
