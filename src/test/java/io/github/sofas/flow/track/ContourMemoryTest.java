package io.github.sofas.flow.track;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNotEquals;
import static org.junit.Assert.assertTrue;

import io.github.sofas.flow.motion.Motion;
import io.github.sofas.flow.motion.PlainMotion;
import io.github.sofas.flow.motion.PlainMotion.Place;
import org.junit.Test;

/** What a structure has looked like, in coordinates that travel, turn and grow with it. */
public class ContourMemoryTest {
    private static Motion motion(long timeUs, double vx, double vy, double omega) {
        Motion motion = new Motion();
        motion.set(timeUs, vx, vy);
        motion.omega = omega;
        motion.centreX = 40 + vx * timeUs * 1e-6;
        motion.centreY = 30 + vy * timeUs * 1e-6;
        return motion;
    }

    /** A vertical edge of twenty pixels at x = 50, seen at time 0 on a structure whose centre is at (40, 30). */
    private static ContourMemory edge(Motion at) {
        ContourMemory shape = new ContourMemory(128, 96);
        shape.start(at);
        shape.follow(at, 1_000_000);
        for (int y = 20; y < 40; y++) {
            shape.see(50, y, 0);
        }
        return shape;
    }

    @Test
    public void remembersWhereItWasSeenAndNowhereElse() {
        ContourMemory shape = edge(motion(0, 0, 0, 0));
        // cells of 2 px from the centre: x 50 and 51 are one; the four around an event are two columns
        assertEquals(2, shape.remembered(50, 30, 1000));
        assertEquals(2, shape.remembered(52, 30, 1000));
        assertEquals(0, shape.remembered(54, 30, 1000));
        assertEquals(0, shape.remembered(47, 30, 1000));
        assertEquals(0, shape.remembered(50, 10, 1000));
    }

    @Test
    public void placesTravelWithTheStructure() {
        // 40 px/s to the right, 20 up: after 0.5 s 20 px and 10 px
        ContourMemory shape = edge(motion(0, 40, -20, 0));
        assertEquals(2, shape.remembered(70, 20, 500_000));
        assertEquals(0, shape.remembered(50, 30, 500_000));
        shape.follow(motion(500_000, 40, -20, 0), 1_000_000);
        assertEquals(2, shape.remembered(70, 20, 500_000));
        assertEquals(2, shape.remembered(78, 16, 700_000));
    }

    @Test
    public void placesTurnWithTheStructure() {
        // a quarter turn a second, from x towards y, followed every 20 ms: what was right of the centre is below it
        double omega = Math.PI / 2;
        ContourMemory shape = edge(motion(0, 0, 0, omega));
        for (int i = 1; i <= 50; i++) {
            shape.follow(motion(i * 20_000, 0, 0, omega), 2_000_000);
        }
        assertTrue(shape.remembered(40, 40, 1_000_000) > 0);
        assertTrue(shape.remembered(34, 40, 1_000_000) > 0);
        assertEquals(0, shape.remembered(50, 30, 1_000_000));
    }

    @Test
    public void placesAreWhereTheyWereAfterAFullTurn() {
        double omega = 2 * Math.PI;
        ContourMemory shape = edge(motion(0, 0, 0, omega));
        for (int i = 1; i <= 100; i++) {
            shape.follow(motion(i * 10_000, 0, 0, omega), 2_000_000);
        }
        for (int y = 22; y < 38; y++) {
            assertTrue(shape.remembered(51, y, 1_000_000) > 0);
            assertEquals(0, shape.remembered(54, y, 1_000_000));
            assertEquals(0, shape.remembered(47, y, 1_000_000));
        }
    }

    @Test
    public void placesAreForgottenAfterTheTimeOfMemory() {
        // seen at 0, remembered for 976 ticks of 1,024 us
        ContourMemory shape = edge(motion(0, 0, 0, 0));
        assertEquals(2, shape.remembered(50, 30, (976L << 10) - 1));
        assertEquals(0, shape.remembered(50, 30, 976L << 10));
    }

    @Test
    public void nothingIsRememberedAtTheStart() {
        ContourMemory shape = edge(motion(0, 0, 0, 0));
        shape.start(motion(10, 0, 0, 0));
        shape.follow(motion(10, 0, 0, 0), 1_000_000);
        assertEquals(0, shape.remembered(50, 30, 20));
    }

    @Test
    public void placesGrowWithTheStructure() {
        // 0.5 1/s for a second, followed every 20 ms: 10 px right of the centre become 10 * 1.6487, and from 9
        // px above it to 9 px below it from 14.8 px above to 14.8 px below
        Motion growing = motion(0, 0, 0, 0);
        growing.growth = 0.5;
        ContourMemory shape = edge(growing);
        for (int i = 1; i <= 50; i++) {
            growing.moveReference(i * 20_000);
            shape.follow(growing, 2_000_000);
        }
        for (int y = 16; y <= 44; y++) {
            assertTrue(shape.remembered(56, y, 1_000_000) > 0);
        }
        assertEquals(0, shape.remembered(56, 50, 1_000_000));
        assertEquals(0, shape.remembered(50, 30, 1_000_000));
        // and on from there: 17.3 px after another tenth
        assertTrue(shape.remembered(57, 30, 1_100_000) > 0);
    }

    @Test
    public void placesAreStretchedWithTheStructure() {
        // 0.5 1/s for a second, followed every 20 ms: 10 px right of the centre become 16.5, and from 9 px above it to
        // 9 px below it 5.5
        Motion stretched = motion(0, 0, 0, 0);
        stretched.deformation.stretch = 0.5;
        ContourMemory shape = edge(stretched);
        for (int i = 1; i <= 50; i++) {
            stretched.moveReference(i * 20_000);
            shape.follow(stretched, 2_000_000);
        }
        for (int y = 26; y <= 34; y++) {
            assertTrue(shape.remembered(56, y, 1_000_000) > 0);
        }
        assertEquals(0, shape.remembered(56, 40, 1_000_000));
        assertEquals(0, shape.remembered(50, 30, 1_000_000));
        // and on from there: 17.3 px after another tenth
        assertTrue(shape.remembered(57, 30, 1_100_000) > 0);
    }

    @Test
    public void whatIsSeenLaterIsAPlaceOfTheStructureToo() {
        // seen at (60, y) after 0.5 s at 20 px/s is the same place as (50, y) at first
        ContourMemory shape = new ContourMemory(128, 96);
        shape.start(motion(0, 20, 0, 0));
        shape.follow(motion(0, 20, 0, 0), 1_000_000);
        for (int y = 20; y < 40; y++) {
            shape.see(60, y, 500_000);
        }
        assertEquals(2, shape.remembered(64, 30, 700_000));
        assertEquals(0, shape.remembered(60, 30, 700_000));
        shape.follow(motion(700_000, 20, 0, 0), 1_000_000);
        assertEquals(2, shape.remembered(64, 30, 700_000));
    }

    @Test
    public void eventsOfEightPixelsAreOnOneTile() {
        ContourMemory shape = edge(motion(0, 0, 0, 0));
        int tile = shape.tile(48, 32, 0);
        assertEquals(tile, shape.tile(55, 32, 0));
        assertEquals(tile, shape.tile(48, 39, 0));
        assertNotEquals(tile, shape.tile(56, 32, 0));
        assertNotEquals(tile, shape.tile(48, 40, 0));
        assertNotEquals(tile, shape.tile(47, 32, 0));
        assertNotEquals(tile, shape.tile(48, 31, 0));
    }

    @Test
    public void aboutHalfOfTheTilesAreEven() {
        // 16 x 12 tiles of the sensor: 96 expected, 7 standard deviation
        ContourMemory shape = edge(motion(0, 0, 0, 0));
        int even = 0;
        for (int y = 4; y < 96; y += 8) {
            for (int x = 4; x < 128; x += 8) {
                even += 1 - (shape.tile(x, y, 0) & 1);
            }
        }
        assertEquals(96, even, 21);
    }

    @Test
    public void tilesMoveAlongWithTheStructure() {
        Motion motion = motion(0, 30, -20, 2);
        motion.growth = -0.4;
        Motion first = new Motion();
        first.copyFrom(motion);
        ContourMemory shape = new ContourMemory(128, 96);
        shape.start(motion);
        shape.follow(motion, 1_000_000);
        // middles of tiles around the centre
        int[][] places = {{36, 28}, {44, 28}, {52, 28}, {28, 36}, {36, 20}};
        int[] tiles = new int[places.length];
        for (int i = 0; i < places.length; i++) {
            tiles[i] = shape.tile(places[i][0], places[i][1], 0);
        }
        for (long timeUs = 20_000; timeUs <= 400_000; timeUs += 20_000) {
            motion.moveReference(timeUs);
            shape.follow(motion, 1_000_000);
            // between two follows, too
            for (long atUs = timeUs; atUs <= timeUs + 20_000; atUs += 10_000) {
                for (int i = 0; i < places.length; i++) {
                    Place now = PlainMotion.at(first, places[i][0], places[i][1], atUs);
                    assertEquals(tiles[i], shape.tile((int) Math.rint(now.x()), (int) Math.rint(now.y()), atUs));
                }
            }
        }
    }

    @Test
    public void leadOfAPlaceIsTheMeanOverItsLastEvents() {
        ContourMemory shape = edge(motion(0, 40, -20, 0));
        assertEquals("of a place that is new", 0, shape.lead(50, 30, 0), 1e-6);
        assertEquals("a 64th of it", 1, shape.takeLead(64, 1), 1e-6);
        assertEquals("another place", 0, shape.lead(54, 30, 0), 1e-6);
        shape.follow(motion(500_000, 40, -20, 0), 1_000_000);
        assertEquals("the same place, later", 1, shape.lead(70, 20, 500_000), 1e-6);
        assertEquals("as of four events: 1 + (17 - 1) / 16", 2, shape.takeLead(17, 4), 1e-6);
        shape.start(motion(500_000, 40, -20, 0));
        assertEquals("begun anew", 0, shape.lead(70, 20, 500_000), 1e-6);
    }
}
