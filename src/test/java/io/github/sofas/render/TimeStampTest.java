package io.github.sofas.render;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import org.junit.Test;

public class TimeStampTest {
    @Test
    public void timeIsRoundedToThousandths() {
        assertEquals("0.000 s", TimeStamp.text(0));
        assertEquals("0.000 s", TimeStamp.text(499));
        assertEquals("0.001 s", TimeStamp.text(500));
        assertEquals("1.000 s", TimeStamp.text(999_500));
        assertEquals("12.034 s", TimeStamp.text(12_034_000));
        assertEquals("3600.100 s", TimeStamp.text(3_600_100_000L));
    }

    /** Seven letters of equal width end at column 80; digits stand on the baseline, at row 20. */
    @Test
    public void timeEndsWhereItIsToEnd() {
        Canvas canvas = new Canvas(96, 32);
        new TimeStamp(0xFFFFFF).paint(canvas, 888_000, 80, 20);
        int left = 96;
        int right = 0;
        int lowest = 0;
        for (int i = 0; i < 96 * 32; i++) {
            if ((canvas.image().getRGB(i % 96, i / 96) & 0xFF) > 128) {
                left = Math.min(left, i % 96);
                right = Math.max(right, i % 96);
                lowest = Math.max(lowest, i / 96);
            }
        }
        assertTrue("from " + left + " to " + right, right < 80 && right > 70 && left > 10 && left < 40);
        assertEquals(20, lowest, 1);
    }
}
