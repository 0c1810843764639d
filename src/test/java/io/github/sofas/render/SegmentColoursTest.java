package io.github.sofas.render;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNotEquals;

import java.util.HashSet;
import java.util.Set;
import org.junit.Test;

public class SegmentColoursTest {
    @Test
    public void segmentsSeenTogetherHaveDifferentColours() {
        for (Theme theme : Theme.values()) {
            SegmentColours colours = new SegmentColours(theme);
            Set<Integer> seen = new HashSet<>();
            for (int id = 1; id <= 12; id++) {
                seen.add(colours.rgb(id * 12));
            }
            assertEquals(theme.toString(), 12, seen.size());
        }
    }

    @Test
    public void segmentKeepsItsColourWhileOthersComeAndGo() {
        SegmentColours colours = new SegmentColours(Theme.DARK);
        int first = colours.rgb(7);
        for (int id = 100; id < 200; id++) {
            assertNotEquals("seen before every new one, so never the longest unseen", first, colours.rgb(id));
            assertEquals(first, colours.rgb(7));
        }
    }

    @Test
    public void newSegmentGetsTheColourUnseenForLongest() {
        SegmentColours colours = new SegmentColours(Theme.LIGHT);
        int first = colours.rgb(1);
        for (int id = 2; id <= 12; id++) {
            colours.rgb(id);
        }
        assertEquals(first, colours.rgb(13));
    }

    @Test
    public void segmentsKeepTheirColoursEvenWhereTheyAreMoreThanThese() {
        SegmentColours colours = new SegmentColours(Theme.DARK);
        int[] first = new int[16];
        for (int id = 1; id <= 16; id++) {
            first[id - 1] = colours.rgb(id);
        }
        for (int id = 1; id <= 16; id++) {
            assertEquals(first[id - 1], colours.rgb(id));
        }
    }
}
