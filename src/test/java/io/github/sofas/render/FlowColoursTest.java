package io.github.sofas.render;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNotEquals;
import static org.junit.Assert.assertTrue;

import org.junit.Test;

public class FlowColoursTest {
    private static final FlowColours DARK = new FlowColours(FlowColours.Wheel.SAFE, Theme.DARK);

    @Test
    public void fourDirectionsHaveTheColoursOfTheWheel() {
        assertEquals("right", 0xFF7A1A, DARK.rgb(100, 0, 100));
        assertEquals("down", 0xB455E8, DARK.rgb(0, 100, 100));
        assertEquals("left", 0x2E8BFF, DARK.rgb(-100, 0, 100));
        assertEquals("up", 0xD2E600, DARK.rgb(0, -100, 100));
    }

    /** The plain way: the nearest of 256 directions, by the arc tangent. */
    @Test
    public void everyDirectionHasTheColourOfTheNearestOfTheWheel() {
        for (int i = 0; i < 4096; i++) {
            double turn = (i + 0.5) / 4096;
            double nearest = Math.rint(turn * 256) / 256;
            assertEquals("turn " + turn, DARK.rgb(Math.cos(2 * Math.PI * nearest), Math.sin(2 * Math.PI * nearest), 1),
                DARK.rgb(3 * Math.cos(2 * Math.PI * turn), 3 * Math.sin(2 * Math.PI * turn), 3));
        }
        assertEquals("at rest", DARK.rgb(1e-9, 0, 100), DARK.rgb(0, 0, 100));
    }

    @Test
    public void fasterThanTheFullSpeedIsNoBrighter() {
        assertEquals(DARK.rgb(100, 0, 100), DARK.rgb(10_000, 0, 100));
    }

    @Test
    public void slowMotionStillHasTheColourOfItsDirection() {
        assertNotEquals(DARK.rgb(1, 0, 1000), DARK.rgb(-1, 0, 1000));
        assertNotEquals(Theme.DARK.faint, DARK.rgb(1, 0, 1000));
    }

    /**
     * Neither red and green nor both kinds of it are needed: a viewer without red cones sees blue and the mean of red
     * and green, roughly, and tells all four directions by these two.
     */
    @Test
    public void fourDirectionsDifferInBlueAndBrightness() {
        for (Theme theme : Theme.values()) {
            FlowColours colours = new FlowColours(FlowColours.Wheel.SAFE, theme);
            int[] rgb = {colours.rgb(1, 0, 1), colours.rgb(0, 1, 1), colours.rgb(-1, 0, 1), colours.rgb(0, -1, 1)};
            for (int i = 0; i < 4; i++) {
                for (int j = i + 1; j < 4; j++) {
                    int blue = Math.abs((rgb[i] & 0xFF) - (rgb[j] & 0xFF));
                    int rest = Math.abs(redAndGreen(rgb[i]) - redAndGreen(rgb[j])) / 2;
                    assertTrue(theme + " directions " + i + " and " + j + ": " + blue + " " + rest,
                        Math.max(blue, rest) >= 20);
                }
            }
        }
    }

    private static int redAndGreen(int rgb) {
        return (rgb >> 16 & 0xFF) + (rgb >> 8 & 0xFF);
    }
}
