package io.github.sofas.render;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.HashSet;
import java.util.Random;
import java.util.Set;
import org.junit.Test;

public class SegmentColoursTest {
    private final SeenSegments seen = new SeenSegments();

    private void see(int id, int x, int y) {
        seen.add(id, x, y, 0, 0);
    }

    @Test
    public void segmentsSeenTogetherHaveDifferentColours() {
        for (Theme theme : Theme.values()) {
            SegmentColours colours = new SegmentColours(theme);
            seen.clear();
            Set<Integer> rgb = new HashSet<>();
            for (int id = 1; id <= 24; id++) {
                see(id * 12, 10 * id, 90);
            }
            colours.assign(seen);
            for (int id = 1; id <= 24; id++) {
                rgb.add(colours.rgb(id * 12));
            }
            assertEquals(theme.toString(), 24, rgb.size());
        }
    }

    @Test
    public void segmentKeepsItsColourWhileOthersComeAndGo() {
        SegmentColours colours = new SegmentColours(Theme.DARK);
        see(7, 100, 100);
        colours.assign(seen);
        int first = colours.rgb(7);
        for (int id = 100; id < 200; id++) {
            seen.clear();
            see(7, 100, 100);
            see(id, id, 110);
            colours.assign(seen);
            assertEquals(first, colours.rgb(7));
        }
    }

    /** Sixty at random places, more than there are colours: the nearest of each looks clearly different. */
    @Test
    public void neighboursNeverLookAlike() {
        for (Theme theme : Theme.values()) {
            SegmentColours colours = new SegmentColours(theme);
            Random random = new Random(5);
            int[] x = new int[60];
            int[] y = new int[60];
            seen.clear();
            for (int i = 0; i < 60; i++) {
                x[i] = random.nextInt(240);
                y[i] = random.nextInt(180);
                see(i + 1, x[i], y[i]);
                colours.assign(seen);
            }
            for (int i = 0; i < 60; i++) {
                int nearest = i == 0 ? 1 : 0;
                for (int j = 0; j < 60; j++) {
                    if (j != i && Math.hypot(x[j] - x[i], y[j] - y[i])
                            < Math.hypot(x[nearest] - x[i], y[nearest] - y[i])) {
                        nearest = j;
                    }
                }
                double difference = SegmentColours.difference(colours.rgb(i + 1), colours.rgb(nearest + 1));
                assertTrue(theme + ": " + (i + 1) + " and " + (nearest + 1) + " differ by " + difference,
                    difference >= 0.13);
            }
        }
    }

    @Test
    public void allColoursDifferFromEachOtherAndFromEventsWithoutFlow() {
        for (Theme theme : Theme.values()) {
            for (int i = 0; i < theme.segments.length; i++) {
                assertTrue(SegmentColours.difference(theme.segments[i], theme.faint) > 0.12);
                assertTrue(SegmentColours.difference(theme.segments[i], theme.sensor) > 0.12);
                for (int j = 0; j < i; j++) {
                    assertTrue(theme + " " + i + " and " + j,
                        SegmentColours.difference(theme.segments[i], theme.segments[j]) > 0.1);
                }
            }
        }
    }

    @Test
    public void colourCanBeGiven() {
        SegmentColours colours = new SegmentColours(Theme.LIGHT);
        colours.assign(5, 3);
        see(5, 10, 10);
        colours.assign(seen);
        assertEquals(Theme.LIGHT.segmentColour(3), colours.rgb(5));
    }

    /** Oklab's lightness is 1 for white and 0 for black, and neither has a hue. */
    @Test
    public void blackDiffersFromWhiteByOne() {
        assertEquals(1, SegmentColours.difference(0x000000, 0xFFFFFF), 1e-3);
        assertEquals(0, SegmentColours.difference(0x123456, 0x123456), 0);
    }
}
