package io.github.sofas.render;

import static org.junit.Assert.assertEquals;

import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import org.junit.Test;

/** A picture of 32 x 32 px, two strips wide, on a ground of one colour. */
public class CanvasTest {
    private static final int GROUND = 0x102030;

    private static Canvas canvas() {
        Canvas canvas = new Canvas(32, 32);
        for (int i = 0; i < 32 * 32; i++) {
            canvas.image().setRGB(i % 32, i / 32, GROUND);
        }
        canvas.keepAsGround();
        return canvas;
    }

    private static int rgb(Canvas canvas, int x, int y) {
        return canvas.image().getRGB(x, y) & 0xFFFFFF;
    }

    @Test
    public void whatIsPaintedIsWipedOff() {
        Canvas canvas = canvas();
        // over the border of two strips
        canvas.fill(15 * 32 + 15, 2, 0xFFFFFF);
        canvas.blend(3, 0xFF0000, 256);
        assertEquals(0xFFFFFF, rgb(canvas, 16, 16));
        assertEquals(0xFF0000, rgb(canvas, 3, 0));
        canvas.wipe();
        for (int i = 0; i < 32 * 32; i++) {
            assertEquals(GROUND, rgb(canvas, i % 32, i / 32));
        }
    }

    @Test
    public void colourIsMixedInByItsShare() {
        Canvas canvas = canvas();
        canvas.blend(0, 0xFF0000, 64);
        // 16 x 3/4 + 255 / 4, 32 x 3/4, 48 x 3/4, rounded down
        assertEquals(75 << 16 | 24 << 8 | 36, rgb(canvas, 0, 0));
    }

    @Test
    public void stampIsPaintedWhereItIsOpaqueAndInsideOnly() {
        BufferedImage stamp = new BufferedImage(2, 2, BufferedImage.TYPE_INT_ARGB);
        stamp.setRGB(0, 0, 0xFF00FF00);
        stamp.setRGB(1, 0, 0x00FFFFFF);
        stamp.setRGB(0, 1, 0xFFFFFFFF);
        stamp.setRGB(1, 1, 0xFFFFFFFF);
        Canvas canvas = canvas();
        canvas.stamp(stamp, 4, 7, new Rectangle(0, 0, 32, 8));
        assertEquals(0x00FF00, rgb(canvas, 4, 7));
        assertEquals("transparent", GROUND, rgb(canvas, 5, 7));
        assertEquals("outside", GROUND, rgb(canvas, 4, 8));
        canvas.stamp(stamp, -1, -1, new Rectangle(0, 0, 32, 8));
        assertEquals(0xFFFFFF, rgb(canvas, 0, 0));
    }
}
