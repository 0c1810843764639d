package io.github.sofas.flow.track;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import org.junit.Test;

/** The ring of a track plane's events, which gives up tiles and not single events. */
public class LiveEventsTest {
    private final LiveEvents live = new LiveEvents();

    /** Fills the ring with one event per µs from 0 on, on tiles 0, 1, 2, ... of 16 in turn. */
    private static void fill(LiveEvents live) {
        for (int i = 0; i < LiveEvents.CAPACITY; i++) {
            live.add(i % 100, i % 90, i, 1, Claim.OWN, i % 16);
        }
    }

    @Test
    public void keepsWhatIsKnownOfAnEvent() {
        live.add(7, 9, 50, 1, Claim.OWN, 3);
        live.add(8, 1, 60, -1, Claim.SHARED, 4);
        live.add(6, 2, 60, 1, Claim.REMEMBERED, 5);
        assertEquals(3, live.size());
        assertEquals(50, live.oldestUs());
        assertEquals(60, live.newestUs());
        int second = live.index(1);
        assertEquals(8, live.x[second]);
        assertEquals(1, live.y[second]);
        assertEquals(-1, live.sign[second]);
        assertEquals(Claim.SHARED, live.claim(second));
        assertEquals(Claim.REMEMBERED, live.claim(live.index(2)));
    }

    @Test
    public void eventsBeforeATimeExpire() {
        for (long timeUs : new long[] {10, 20, 20, 30}) {
            live.add(0, 0, timeUs, 1, Claim.OWN, 0);
        }
        live.expire(10);
        assertEquals(4, live.size());
        live.expire(20);
        assertEquals(3, live.size());
        assertEquals(20, live.oldestUs());
        live.expire(31);
        assertEquals(0, live.size());
    }

    @Test
    public void fullRingGivesUpEveryOtherTileAsAWhole() {
        fill(live);
        assertTrue(live.isFull());
        assertEquals(1, live.thinning());
        live.add(5, 5, 40_000, 1, Claim.OWN, 6);
        // half of its 32,768 and the new one, all of even tiles
        assertEquals(2, live.thinning());
        assertEquals(16_385, live.size());
        for (int k = 0; k < 16_384; k++) {
            assertEquals(2 * k, live.timeUs[live.index(k)]);
            assertEquals(2 * k % 100, live.x[live.index(k)]);
            assertEquals(2 * k % 90, live.y[live.index(k)]);
        }
        assertEquals(40_000, live.newestUs());
    }

    @Test
    public void tilesThatWereGivenUpAreNotTakenAgain() {
        fill(live);
        live.add(5, 5, 40_000, 1, Claim.OWN, 7);
        assertEquals(16_384, live.size());
        assertFalse(live.takes(7));
        assertTrue(live.takes(6));
        live.add(5, 5, 40_000, 1, Claim.OWN, 7);
        assertEquals(16_384, live.size());
    }

    @Test
    public void ringThatIsFullAgainHalvesItsTilesAgain() {
        fill(live);
        for (int i = 0; i < 16_385; i++) {
            live.add(5, 5, 40_000 + i, 1, Claim.OWN, 4 * (i & 1) + 2 * (i >> 1 & 1));
        }
        // 16,384 of the first were left; of the new ones, of tiles 0, 4, 2 and 6, those of tiles 0 and 4 stayed
        assertEquals(4, live.thinning());
        assertTrue("size " + live.size(), live.size() >= LiveEvents.CAPACITY / 4);
        assertTrue("size " + live.size(), live.size() <= LiveEvents.CAPACITY * 3 / 4);
    }

    @Test
    public void oldestGoesWhereAllEventsLieOnOneTile() {
        for (int i = 0; i <= LiveEvents.CAPACITY; i++) {
            live.add(0, 0, i, 1, Claim.OWN, 1 << 20);
        }
        assertTrue(live.isFull());
        assertEquals(1, live.oldestUs());
        assertEquals(LiveEvents.CAPACITY, live.newestUs());
        assertEquals(1, live.thinning());
    }

    @Test
    public void ringBelowAQuarterTakesTwiceAsManyTiles() {
        fill(live);
        live.add(5, 5, 40_000, 1, Claim.OWN, 6);
        live.widen();
        assertEquals("more than a quarter", 2, live.thinning());
        // every other µs from 16,386 on: 8,191 events, and the last one
        live.expire(16_386);
        assertEquals(8_192, live.size());
        live.widen();
        assertEquals("a quarter", 2, live.thinning());
        live.expire(16_388);
        live.widen();
        assertEquals(1, live.thinning());
        assertTrue(live.takes(7));
        live.widen();
        assertEquals(1, live.thinning());
    }

    @Test
    public void eventsOfBeforeTilesWereTakenAgainStandForAsManyAsBefore() {
        fill(live);
        assertEquals(32_768, live.given());
        live.add(5, 5, 40_000, 1, Claim.OWN, 6);
        assertEquals(2 * 16_385, live.given());
        // every other µs from 16,388 on: 8,190 events, and the last one
        live.expire(16_388);
        live.widen();
        assertEquals(2 * 8_191, live.given());
        live.add(5, 5, 40_001, 1, Claim.OWN, 7);
        assertEquals(2 * 8_191 + 1, live.given());
        live.expire(16_390);
        assertEquals(2 * 8_190 + 1, live.given());
        live.expire(40_001);
        assertEquals(1, live.given());
    }

    @Test
    public void eventsThatAreGivenUpStandForNoOthersAnyMore() {
        fill(live);
        live.add(5, 5, 40_000, 1, Claim.OWN, 6);
        // every other µs from 16,388 on: 8,190 events, and the last one
        live.expire(16_388);
        live.widen();
        live.add(5, 5, 40_001, 1, Claim.OWN, 7);
        live.add(5, 5, 40_002, 1, Claim.OWN, 7);
        // every fourth µs from 16,388 on: 4,095 events, each for two; the last one of these tiles, and one of all
        live.keepIf(i -> live.timeUs[i] % 4 == 0 || live.timeUs[i] == 40_001);
        assertEquals(4_097, live.size());
        assertEquals(2 * 4_096 + 1, live.given());
        live.expire(40_000);
        assertEquals(2 + 1, live.given());
    }

    @Test
    public void newestAreKept() {
        for (long timeUs : new long[] {10, 20, 30, 40}) {
            live.add(0, 0, timeUs, 1, Claim.OWN, 0);
        }
        live.keepNewest(5);
        assertEquals(4, live.size());
        live.keepNewest(3);
        assertEquals(3, live.size());
        assertEquals(20, live.oldestUs());
    }

    @Test
    public void tilesThatAreLeftByHalvingAreThoseThatWouldBeTaken() {
        fill(live);
        live.add(5, 5, 40_000, 1, Claim.OWN, 6);
        // those of even tiles are taken: halved once more, those of every fourth
        assertEquals(16_385, live.size());
        int left = 0;
        for (int k = 0; k < 16_384; k++) {
            assertTrue(live.isLeftBy(0, live.index(k)));
            left += live.isLeftBy(1, live.index(k)) ? 1 : 0;
        }
        assertEquals(8_192, left);
    }

    @Test
    public void middleIsThatBetweenTheOldestAndTheNewest() {
        for (long timeUs : new long[] {10, 20, 50}) {
            live.add(0, 0, timeUs, 1, Claim.OWN, 0);
        }
        assertEquals(30, live.middleUs());
    }

    @Test
    public void ringThatIsClearedTakesEveryTile() {
        fill(live);
        live.add(5, 5, 40_000, 1, Claim.OWN, 6);
        live.clear();
        assertEquals(0, live.size());
        assertEquals(1, live.thinning());
    }

    @Test
    public void twoRingsAreMergedInOrderOfTime() {
        LiveEvents other = new LiveEvents();
        for (long timeUs : new long[] {10, 20, 40}) {
            live.add(1, 0, timeUs, 1, Claim.OWN, 1);
        }
        for (long timeUs : new long[] {5, 20, 30, 50}) {
            other.add(2, 0, timeUs, -1, Claim.SHARED, 3);
        }
        LiveEvents both = new LiveEvents();
        both.add(9, 9, 9, 1, Claim.OWN, 0);
        both.fillFrom(live, other);
        long[] times = {5, 10, 20, 20, 30, 40, 50};
        int[] columns = {2, 1, 1, 2, 2, 1, 2};
        assertEquals(times.length, both.size());
        for (int k = 0; k < times.length; k++) {
            assertEquals(times[k], both.timeUs[both.index(k)]);
            assertEquals(columns[k], both.x[both.index(k)]);
            assertEquals(columns[k] == 1 ? Claim.OWN : Claim.SHARED, both.claim(both.index(k)));
        }
    }

    @Test
    public void mergedRingHoldsTheTilesThatBothTake() {
        fill(live);
        live.add(5, 5, 40_000, 1, Claim.OWN, 6);
        LiveEvents other = new LiveEvents();
        other.add(1, 1, 40_001, 1, Claim.OWN, 7);
        other.add(1, 1, 40_002, 1, Claim.OWN, 8);
        LiveEvents both = new LiveEvents();
        both.fillFrom(other, live);
        assertEquals(2, both.thinning());
        assertEquals(16_386, both.size());
        assertEquals(40_002, both.newestUs());
    }

    @Test
    public void twoFullRingsAreThinnedToFitOne() {
        fill(live);
        LiveEvents other = new LiveEvents();
        fill(other);
        LiveEvents both = new LiveEvents();
        both.fillFrom(live, other);
        // 65,536 of all tiles, 32,768 of every other one
        assertEquals(2, both.thinning());
        assertEquals(32_768, both.size());
        assertEquals(0, both.oldestUs());
        assertEquals(32_766, both.newestUs());
    }

    @Test
    public void commonPolarityIsThatOfMoreThanFourFifthsOfTheEventsThatAreLeft() {
        assertEquals(0, live.commonPolarity());
        for (int i = 0; i < 11; i++) {
            live.add(0, 0, i, i < 9 ? 1 : -1, Claim.OWN, i);
        }
        assertEquals(1, live.commonPolarity());
        live.expire(1);
        assertEquals("eight of ten", 0, live.commonPolarity());
        live.keepIf(i -> live.sign[i] < 0);
        assertEquals(-1, live.commonPolarity());
        LiveEvents both = new LiveEvents();
        both.fillFrom(live, live);
        assertEquals(-1, both.commonPolarity());
        live.clear();
        assertEquals(0, live.commonPolarity());
    }

    @Test
    public void commonPolarityIsThatOfTheTilesThatAreLeft() {
        for (int i = 0; i <= LiveEvents.CAPACITY; i++) {
            live.add(0, 0, i, i % 2 == 0 ? 1 : -1, Claim.OWN, i % 16);
        }
        assertEquals(2, live.thinning());
        assertEquals(1, live.commonPolarity());
    }
}
