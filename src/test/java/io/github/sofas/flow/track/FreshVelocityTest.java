package io.github.sofas.flow.track;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.motion.Motion;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.Test;

/**
 * Texture of 150 dots that fire three times, 2 ms apart, whenever they come to another pixel, as real ones do: at rest
 * its events meet two of three times.
 */
public class FreshVelocityTest {
    private static final int DOTS = 150;
    private static final int TIMES = 3;
    private static final long AGAIN_US = 2_000;
    /** Standard deviations by which a new velocity is to be better. */
    private static final double SIGMAS = 10;

    private final MetricFit fit = new MetricFit(128, 96, MetricFit.CELL_PX, LiveEvents.CAPACITY, 1000);
    private final FreshVelocity fresh = new FreshVelocity();

    /** An event. */
    private record Fired(long timeUs, int x, int y) {
    }

    /** The events of a texture that goes to the right by 100 px/s and down by 50 px/s, 4.5 px in 40 ms. */
    private static List<Fired> events() {
        Random random = new Random(7);
        List<Fired> events = new ArrayList<>();
        for (int dot = 0; dot < DOTS; dot++) {
            double x0 = 40 + 40 * random.nextDouble();
            double y0 = 30 + 30 * random.nextDouble();
            int column = (int) Math.floor(x0);
            int row = (int) Math.floor(y0);
            for (long t = 0; t < 40_000; t += 50) {
                int x = (int) Math.floor(x0 + 100e-6 * t);
                int y = (int) Math.floor(y0 + 50e-6 * t);
                if (x != column || y != row) {
                    for (int k = 0; k < TIMES; k++) {
                        events.add(new Fired(t + k * AGAIN_US, x, y));
                    }
                    column = x;
                    row = y;
                }
            }
        }
        events.sort((a, b) -> Long.compare(a.timeUs(), b.timeUs()));
        return events;
    }

    private static LiveEvents live(List<Fired> events) {
        LiveEvents live = new LiveEvents();
        Random tiles = new Random(1);
        events.forEach(e -> live.add(e.x(), e.y(), e.timeUs(), 1, Claim.OWN, tiles.nextInt()));
        return live;
    }

    private static Motion motion(long timeUs, double vx, double vy) {
        Motion motion = new Motion();
        motion.set(timeUs, vx, vy);
        return motion;
    }

    @Test
    public void velocityOfWhatIsTakenToRestIsFound() {
        LiveEvents live = live(events());
        assertTrue(fresh.find(live, live.size(), 4, SIGMAS, motion(40_000, 0, 0), 15, fit));
        assertEquals(100, fresh.vx(), 5);
        assertEquals(50, fresh.vy(), 5);
    }

    @Test
    public void velocityOfFewTilesIsThatOfAll() {
        // two textures on two tiles, together more than the 3,000 events that are looked at
        List<Fired> many = new ArrayList<>();
        events().forEach(e -> {
            many.add(e);
            many.add(new Fired(e.timeUs(), e.x(), e.y() + 30));
        });
        LiveEvents live = new LiveEvents();
        many.forEach(e -> live.add(e.x(), e.y(), e.timeUs(), 1, Claim.OWN, e.y() >= 60 ? 1 : 2));
        assertTrue("" + live.size(), live.size() > 3000);
        assertTrue(fresh.find(live, live.size(), 4, SIGMAS, motion(40_000, 0, 0), 15, fit));
        assertTrue("" + fit.size(), fit.size() <= 3000);
        assertEquals(100, fresh.vx(), 5);
        assertEquals(50, fresh.vy(), 5);
    }

    @Test
    public void whatMovesAsItIsTakenToHasNoOtherVelocity() {
        LiveEvents live = live(events());
        assertFalse(fresh.find(live, live.size(), 4, SIGMAS, motion(40_000, 100, 50), 15, fit));
    }

    @Test
    public void whatFlickersHasNoVelocity() {
        Random random = new Random(3);
        List<Fired> events = new ArrayList<>();
        for (int i = 0; i < 2000; i++) {
            events.add(new Fired(20L * i, 40 + random.nextInt(40), 30 + random.nextInt(30)));
        }
        LiveEvents live = live(events);
        assertFalse(fresh.find(live, live.size(), 4, SIGMAS, motion(40_000, 0, 0), 15, fit));
    }

    @Test
    public void eventsThatOthersClaimTellNothing() {
        LiveEvents live = new LiveEvents();
        events().forEach(e -> live.add(e.x(), e.y(), e.timeUs(), 1, Claim.SHARED, 0));
        assertFalse(fresh.find(live, live.size(), 4, SIGMAS, motion(40_000, 0, 0), 15, fit));
    }
}
