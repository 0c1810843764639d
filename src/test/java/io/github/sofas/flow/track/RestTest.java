package io.github.sofas.flow.track;

import static org.junit.Assert.assertEquals;

import io.github.sofas.flow.motion.Motion;
import org.junit.Test;

/**
 * An edge that goes on at 50 px/s and gives an event each ms until 99 ms: 20 a px, of which the newest eight, as many
 * as of 0.4 px, begin at 92 ms. In the 30 ms from then on it goes on by 1.5 px.
 */
public class RestTest {
    private static final double LIFETIME_PX = 5;
    private static final long SINCE_US = 92_000;

    private final Rest rest = new Rest();
    private final EventDensity density = new EventDensity();
    private final Motion motion = new Motion();

    private static LiveEvents events(int n, int everyUs) {
        LiveEvents live = new LiveEvents();
        for (int i = 0; i < n; i++) {
            live.add(i / 20, i % 20, (long) i * everyUs, 1, Claim.OWN, 0);
        }
        return live;
    }

    private LiveEvents edge() {
        LiveEvents live = events(100, 1000);
        density.start(live, LIFETIME_PX);
        motion.set(0, 50, 0);
        return live;
    }

    private long sinceUs(LiveEvents live, boolean inView, long nowUs) {
        return rest.sinceUs(motion, live, density, 0, inView, nowUs);
    }

    @Test
    public void whatGivesTooFewEventsOverThePixelsThatItShouldGoOnByIsAtRest() {
        LiveEvents live = edge();
        assertEquals(Rest.NEVER, sinceUs(live, true, 100_000));
        assertEquals(Rest.NEVER, sinceUs(live, true, 121_900));
        assertEquals(SINCE_US, sinceUs(live, true, 122_100));
    }

    @Test
    public void whatMayBeHiddenIsNotAtRestUnlessItWasToTurnBack() {
        LiveEvents live = edge();
        assertEquals(Rest.NEVER, sinceUs(live, false, 200_000));
        // from 50 px/s at 92 ms to as much the other way at 192 ms, by 2.5 px
        motion.set(142_000, 0, 0);
        motion.ax = -1000;
        assertEquals(SINCE_US, sinceUs(live, false, 192_000));
        // to 10 px/s, by 2.25 px
        motion.set(142_000, 30, 0);
        motion.ax = -400;
        assertEquals(Rest.NEVER, sinceUs(live, false, 192_000));
    }

    @Test
    public void pausesAsThoseOfASourceThatSeesInFramesAreNoRest() {
        // 40 events each 40 ms, of 2 px of travel: the fourth frame at 120 ms
        LiveEvents live = new LiveEvents();
        for (int i = 0; i < 160; i++) {
            live.add(i / 20, i % 20, i / 40 * 40_000, 1, Claim.OWN, 0);
        }
        density.start(live, 8);
        motion.set(0, 50, 0);
        assertEquals(Rest.NEVER, sinceUs(live, true, 160_000));
        assertEquals(Rest.NEVER, sinceUs(live, true, 199_000));
        assertEquals(120_000, sinceUs(live, true, 200_000));
    }

    @Test
    public void whatHasLessThanThoseLeftRestsSinceTheOldest() {
        edge();
        LiveEvents live = new LiveEvents();
        live.add(5, 0, 98_000, 1, Claim.OWN, 0);
        live.add(5, 1, 99_000, 1, Claim.OWN, 0);
        assertEquals(98_000, sinceUs(live, true, 130_000));
        assertEquals("nothing is known of it", Rest.NEVER, sinceUs(new LiveEvents(), true, 130_000));
    }

    @Test
    public void fewEventsTellNothing() {
        edge();
        // nine a px: three of 0.4 px
        LiveEvents live = events(45, 2222);
        density.start(live, LIFETIME_PX);
        assertEquals(Rest.NEVER, sinceUs(live, true, 300_000));
    }
}
