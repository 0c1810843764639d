package io.github.sofas.flow.search;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.fit.MetricFit;
import java.util.Random;
import org.junit.Test;

/** What the events of a region show. All moves right at 100 px/s, a pixel in 10 ms. */
public class RegionRefinementTest {
    private static final SensorSize SENSOR = new SensorSize(64, 64);
    private static final long PX_US = 10_000;

    private final RecentEvents events = new RecentEvents(SENSOR);
    private final DenseRegions regions = new DenseRegions(SENSOR, events);
    private final MetricFit fit = new MetricFit(64, 64, MetricFit.CELL_PX, 4096, 300);
    private final RegionRefinement refinement = new RegionRefinement(regions, events, fit);

    private void add(int x, int y, long timeUs, int polarity) {
        if (x < SENSOR.width()) {
            events.add(x, y, timeUs, polarity);
            regions.add(x, y, timeUs);
        }
    }

    /** Points of texture, each of which fires at every pixel on its way, over so many pixels and one more. */
    private void film(int points, int travelPx, int fromX, int untilX) {
        Random random = new Random(1);
        int[] x = random.ints(points, fromX, untilX).toArray();
        int[] y = random.ints(points, 0, 64).toArray();
        for (int step = 0; step <= travelPx; step++) {
            for (int i = 0; i < points; i++) {
                add(x[i] + step, y[i], step * PX_US + i, i % 2 == 0 ? 1 : -1);
            }
        }
    }

    /** Refines the region; returns the number of fits. */
    private int refine() {
        assertTrue(regions.isAnyDue());
        refinement.begin();
        int fits = 0;
        while (!refinement.isOver()) {
            refinement.step();
            fits++;
        }
        return fits;
    }

    @Test
    public void textureThatHasTravelledFourPixelsShowsItsVelocity() {
        film(400, 4, 0, 64);
        refine();
        assertTrue(refinement.isStructure());
        assertEquals(100, refinement.vx(), 5);
        assertEquals(0, refinement.vy(), 5);
        assertEquals(0.0404, refinement.windowS(), 1e-4);
        assertEquals(0, refinement.left());
        assertEquals(0, refinement.top());
    }

    @Test
    public void textureThatHasTravelledTwoPixelsDoesNotYet() {
        film(400, 2, 0, 64);
        assertTrue(refine() > 1);
        assertFalse(refinement.isStructure());
    }

    @Test
    public void whatHasTravelledSevenPixelsIsLeftOfATextureThatWasFound() {
        film(400, 7, 0, 64);
        assertTrue(refine() > 1);
        assertFalse(refinement.isStructure());
    }

    @Test
    public void regionThatShowedAStructureBeginsAnew() {
        film(400, 4, 0, 64);
        refine();
        film(100, 4, 0, 64);
        assertFalse(regions.isAnyDue());
    }

    @Test
    public void middleOfAVeryDenseRegionIsFitted() {
        film(1000, 4, 0, 64);
        refine();
        assertTrue(refinement.isStructure());
        // a quarter of nearly 5,000 events
        assertTrue("fitted " + fit.size(), fit.size() > 1000 && fit.size() < 1500);
        assertEquals(100, refinement.vx(), 10);
    }

    @Test
    public void edgesThatFillAThirdAreNoTexture() {
        film(400, 4, 0, 20);
        assertEquals(0, refine());
        assertFalse(refinement.isStructure());
    }

    @Test
    public void noiseIsGivenUpBeforeAnyFit() {
        Random random = new Random(3);
        for (int i = 0; i < 2000; i++) {
            add(random.nextInt(64), random.nextInt(64), i * 20L, random.nextBoolean() ? 1 : -1);
        }
        assertEquals(0, refine());
        assertFalse(refinement.isStructure());
    }

    @Test
    public void outlineInNoiseIsNoTexture() {
        // noise fills the region, and the edges of a square of 24 px that moves four px make it sharper than at rest
        Random random = new Random(4);
        for (int step = 0; step <= 4; step++) {
            for (int i = 0; i < 160; i++) {
                add(random.nextInt(64), random.nextInt(64), step * PX_US + i, random.nextBoolean() ? 1 : -1);
            }
            for (int i = 0; i < 24; i++) {
                add(20 + step, 20 + i, step * PX_US + 200, 1);
                add(44 + step, 20 + i, step * PX_US + 200, -1);
                add(20 + step + i, 20, step * PX_US + 200, 1);
                add(20 + step + i, 44, step * PX_US + 200, -1);
            }
        }
        assertTrue(refine() > 1);
        assertFalse(refinement.isStructure());
        assertEquals(100, refinement.vx(), 10);
    }

    @Test
    public void eventsThatAStructureTookAreLeftOut() {
        film(400, 4, 0, 64);
        for (int event = events.oldest(); event != events.head(); event++) {
            events.take(event);
        }
        assertEquals(0, refine());
        assertFalse(refinement.isStructure());
    }

    @Test
    public void eventsOfOneMomentShowNothing() {
        Random random = new Random(5);
        for (int i = 0; i < 1000; i++) {
            add(random.nextInt(64), random.nextInt(64), 7, 1);
        }
        assertEquals(0, refine());
        assertFalse(refinement.isStructure());
    }
}
