package io.github.sofas.flow.track;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.util.Random;
import org.junit.Test;

/** Boxes compared by one subtraction, beside four comparisons. */
public class ReachesTest {
    @Test
    public void eventLiesInABoxAsFourComparisonsSay() {
        Random random = new Random(7);
        int inside = 0;
        for (int i = 0; i < 100_000; i++) {
            int left = random.nextInt(1400) - 60;
            int top = random.nextInt(800) - 40;
            int right = left + random.nextInt(400);
            int bottom = top + random.nextInt(300);
            int x = random.nextInt(1280);
            int y = random.nextInt(720);
            boolean lies = x >= left && x <= right && y >= top && y <= bottom;
            inside += lies ? 1 : 0;
            assertEquals(lies, Reaches.holds(Reaches.box(left, top, right, bottom), Reaches.event(x, y)));
        }
        assertTrue(inside > 1_000);
    }

    @Test
    public void sidesBelongToTheBox() {
        long box = Reaches.box(10, 20, 30, 40);
        assertTrue(Reaches.holds(box, Reaches.event(10, 20)));
        assertTrue(Reaches.holds(box, Reaches.event(30, 40)));
        assertFalse(Reaches.holds(box, Reaches.event(9, 20)));
        assertFalse(Reaches.holds(box, Reaches.event(10, 19)));
        assertFalse(Reaches.holds(box, Reaches.event(31, 40)));
        assertFalse(Reaches.holds(box, Reaches.event(30, 41)));
    }

    @Test
    public void placesWithinAPixelAreHeld() {
        // from 9.2 on column 9 may lie in it, and to 30.9 no column beyond 30
        assertTrue(Reaches.holds(Reaches.box(9.2, 0, 30.9, 5), Reaches.event(9, 5)));
        assertFalse(Reaches.holds(Reaches.box(9.2, 0, 30.9, 5), Reaches.event(31, 5)));
    }

    @Test
    public void boxFarBeyondTheSensorIsCutOff() {
        assertTrue(Reaches.holds(Reaches.box(-1e9, -1e9, 1e9, 1e9), Reaches.event(1279, 719)));
        assertFalse(Reaches.holds(Reaches.box(-50, -50, -20, -20), Reaches.event(1, 1)));
        assertFalse(Reaches.holds(Reaches.NOWHERE, Reaches.event(1279, 719)));
        assertFalse(Reaches.holds(Reaches.NOWHERE, Reaches.event(0, 0)));
    }

    @Test
    public void boxesAreKnownFromWhenTheyAreTakenUntilTheyAreOver() {
        Reaches reaches = new Reaches();
        assertFalse(reaches.areKnownAt(0));
        reaches.take(new TrackPlane[4], 0, 100, 200);
        assertTrue(reaches.areKnownAt(200));
        assertFalse(reaches.areKnownAt(201));
        reaches.forget();
        assertFalse(reaches.areKnownAt(150));
    }
}
