package io.github.sofas.report;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.util.List;
import org.junit.Test;

/** A step is 33,333 µs; the clip has 300. */
public class HighlightsTest {
    private final Highlights highlights = new Highlights();

    private void add(long step, int events, boolean hasFlow) {
        for (int i = 0; i < events; i++) {
            highlights.add(step * 33_333 + i, hasFlow);
        }
    }

    @Test
    public void clipOfAShortRecordingIsAllOfIt() {
        add(0, 1, true);
        add(120, 3, false);
        highlights.finish();
        assertEquals(0, highlights.clipFirst());
        assertEquals(121, highlights.clipEnd());
        assertTrue(highlights.clipIsAll());
    }

    @Test
    public void clipIsWhereMostEventsHaveFlow() {
        add(10, 10_000, false);
        for (int step = 20; step < 1000; step++) {
            add(step, step >= 400 && step < 700 ? 3 : 2, true);
        }
        highlights.finish();
        // of 900 events less than 9 may be left out at the beginning: two steps' 6
        assertEquals(402, highlights.clipFirst());
        assertEquals(702, highlights.clipEnd());
        assertFalse(highlights.clipIsAll());
    }

    @Test
    public void whatWasBeforeAPauseDoesNotCountAfterIt() {
        add(0, 10, true);
        // more than a clip later, then within one
        add(400, 6, true);
        add(600, 5, true);
        highlights.finish();
        // 6 + 5 end with step 600
        assertEquals(301, highlights.clipFirst());
        assertEquals(601, highlights.clipEnd());
    }

    @Test
    public void clipBeginsWhereSomethingMoves() {
        for (int step = 0; step < 1000; step++) {
            add(step, 10, step >= 500 && step < 600);
        }
        highlights.finish();
        // of 1,000 events less than 10 may be left out: none
        assertEquals(500, highlights.clipFirst());
        assertEquals(800, highlights.clipEnd());
    }

    @Test
    public void clipIsTenSecondsWhereTheRecordingHasThem() {
        for (int step = 0; step < 1000; step++) {
            add(step, 10, step >= 950);
        }
        highlights.finish();
        assertEquals(700, highlights.clipFirst());
        assertEquals(1000, highlights.clipEnd());
    }

    @Test
    public void clipBeginsTheRecordingWhereNothingMoves() {
        for (int step = 0; step < 500; step++) {
            add(step, 1, false);
        }
        highlights.finish();
        assertEquals(0, highlights.clipFirst());
        assertEquals(300, highlights.clipEnd());
    }

    @Test
    public void ofCloseMomentsTheBusiestCounts() {
        add(5, 3, true);
        add(7, 4, true);
        add(9, 2, false);
        add(50, 1, false);
        highlights.finish();
        assertEquals(List.of(new Highlights.Moment(7, 4), new Highlights.Moment(50, 1)), highlights.moments());
    }

    @Test
    public void sixBusiestMomentsCountInOrderOfTime() {
        int[] events = {5, 2, 9, 4, 7, 3, 8, 6};
        for (int i = 0; i < events.length; i++) {
            add(20L * i, events[i], true);
        }
        highlights.finish();
        assertEquals("those of 2 and 3 left out", List.of(new Highlights.Moment(0, 5), new Highlights.Moment(40, 9),
            new Highlights.Moment(60, 4), new Highlights.Moment(80, 7), new Highlights.Moment(120, 8),
            new Highlights.Moment(140, 6)), highlights.moments());
    }
}
