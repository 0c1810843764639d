package io.github.sofas.flow.smooth;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.motion.Motion;
import java.util.ArrayList;
import java.util.List;
import org.junit.Test;

/**
 * Two upright edges of 20 rows that meet: 1 goes to the right by a column each 10 ms, from column 20 at 0 s; 2 to the
 * left, from column 61: at 200 ms they are a pixel apart, and either may have the events of both. Slices of 50 ms.
 */
public class CompetitionTest {
    private static final SensorSize SENSOR = new SensorSize(96, 64);
    private static final long COLUMN_US = 10_000;
    private static final long SLICE_US = 50_000;

    private final EventWindow window = new EventWindow();
    private final Competition competition = new Competition(SENSOR, window, new Labels());
    private final List<Slice> slices = new ArrayList<>();
    private final List<SegmentPath> paths = new ArrayList<>();
    private double noisePerUs;

    private void addPath(int id, double vx, double startX) {
        Motion motion = new Motion();
        motion.set(0, vx, 0);
        motion.centreX = startX;
        motion.centreY = 30;
        SegmentPath path = new SegmentPath(id);
        path.add(motion);
        paths.add(path);
    }

    /** Events of a column each, with the labels that they are first given. */
    private void film(int columns, int first, int second) {
        addPath(1, 100, 20);
        addPath(2, -100, 61);
        for (int c = 0; c < columns; c++) {
            for (int y = 20; y < 40; y++) {
                window.give(window.add(c * COLUMN_US, 0, 20 + c, y, 1), first, first);
                window.give(window.add(c * COLUMN_US, 0, 61 - c, y, 1), second, second);
            }
            endSlice((c + 1) * COLUMN_US);
        }
    }

    /** Ends a slice, if one ends at that time. */
    private void endSlice(long us) {
        if (us % SLICE_US == 0) {
            long from = slices.isEmpty() ? 0 : slices.get(slices.size() - 1).until;
            slices.add(new Slice(window, SENSOR, from, us - SLICE_US, us, noisePerUs));
        }
    }

    /** Events of a segment among those of one of the edges, but for the 20 where they meet. */
    private int countOf(int id, int parity) {
        int count = 0;
        for (long i = parity; i < window.end(); i += 2) {
            int k = window.at(i);
            count += window.segment[k] == id && window.timeUs[k] != 200_000 ? 1 : 0;
        }
        return count;
    }

    @Test
    public void eventsBetweenTwoEdgesGoWhereTheirEdgeCameFromAndWentTo() {
        film(40, 1, 2);
        // where they meet, in columns 35 to 44, at 150 to 250 ms, all have the wrong label
        for (int k = 3; k < 5; k++) {
            for (long i = slices.get(k).from; i < slices.get(k).until; i++) {
                window.give(window.at(i), i % 2 == 0 ? 2 : 1, i % 2 == 0 ? 2 : 1);
            }
        }
        for (int k = 0; k < slices.size(); k++) {
            competition.decide(slices, k, paths, 100_000, false);
        }
        // but for the column beside the one where they meet, where chance has as many
        assertEquals(39 * 20, countOf(1, 0), 20);
        assertEquals(39 * 20, countOf(2, 1), 20);
    }

    @Test
    public void unlabelledEventsOfBeforeAreLabelled() {
        film(30, 1, 2);
        for (int k = 0; k < 3; k++) {
            for (long i = slices.get(k).from; i < slices.get(k).until; i++) {
                window.give(window.at(i), 0, 0);
            }
        }
        // as they were found later
        List<Slice> found = new ArrayList<>();
        for (Slice slice : slices) {
            found.add(new Slice(until(slice.until), SENSOR, slice.from, slice.fromUs, slice.untilUs, 0));
        }
        slices.clear();
        slices.addAll(found);
        for (int k = 0; k < slices.size(); k++) {
            competition.decide(slices, k, paths, 100_000, false);
        }
        assertEquals(29 * 20, countOf(1, 0));
        assertEquals(29 * 20, countOf(2, 1));
    }

    @Test
    public void eventsOfJustBeforeASegmentWasFoundAreLabelled() {
        addPath(1, 100, 20);
        // found a column after the second slice, of ten columns, began: of what is about there, a tenth has no label
        long foundUs = 11 * COLUMN_US;
        paths.get(0).see(foundUs);
        long from = 0;
        for (int c = 0; c < 30; c++) {
            for (int y = 20; y < 40; y++) {
                int label = c * COLUMN_US < foundUs ? 0 : 1;
                window.give(window.add(c * COLUMN_US, 0, 20 + c, y, 1), label, label);
            }
            if ((c + 1) % 10 == 0) {
                slices.add(new Slice(window, SENSOR, from, (c - 9) * COLUMN_US, (c + 1) * COLUMN_US, 0));
                from = window.end();
            }
        }
        assertFalse(slices.get(1).isOpen(0));
        for (int k = slices.size() - 1; k >= 0; k--) {
            competition.decide(slices, k, paths, 200_000, false);
        }
        int count = 0;
        for (long i = 0; i < window.end(); i++) {
            count += window.segment[window.at(i)];
        }
        assertEquals(30 * 20, count);
    }

    @Test
    public void eventsThatAnotherHadBeforeASegmentWasFoundAreIts() {
        // until just before the edges meet
        film(20, 1, 2);
        // until 150 ms the edges are a tile apart, and nothing tells that another segment may have events there
        for (long i = 0; i < slices.get(2).until; i++) {
            window.give(window.at(i), 2, 2);
        }
        for (int k = 0; k < 3; k++) {
            Slice slice = slices.get(k);
            slices.set(k, new Slice(until(slice.until), SENSOR, slice.from, slice.fromUs, slice.untilUs, 0));
            assertFalse(slices.get(k).isOpen(0));
        }
        for (int k = slices.size() - 1; k >= 0; k--) {
            competition.decide(slices, k, paths, 200_000, false);
        }
        assertEquals(20 * 20, countOf(1, 0));
        assertEquals(20 * 20, countOf(2, 1));
    }

    /** The events before a number. */
    private EventWindow until(long end) {
        EventWindow part = new EventWindow();
        for (long i = 0; i < end; i++) {
            int k = window.at(i);
            part.give(part.add(window.timeUs[k], 0, window.x[k], window.y[k], window.polarity[k]),
                window.segment[k], window.label[k]);
        }
        return part;
    }

    /** Events that have a label in the end, of three columns of either edge of which the last one was labelled. */
    private int labelledOfThreeColumns(boolean isAll) {
        // of before what is seen
        int before = isAll ? 0 : 2;
        for (int i = 0; i < before; i++) {
            window.give(window.add(0, 0, 0, 0, 1), 0, 0);
        }
        film(3, 0, 0);
        for (long i = window.end() - 40; i < window.end(); i++) {
            int id = 1 + (int) (i & 1);
            window.give(window.at(i), id, id);
        }
        slices.add(new Slice(window, SENSOR, before, 0, SLICE_US, noisePerUs));
        // eight parts of a column each
        competition.decide(slices, 0, paths, 80_000, isAll);
        return countOf(1, 0) + countOf(2, 1);
    }

    @Test
    public void claimsCountForMoreWhereARecordingHasBegunAndEnded() {
        // an event meets its edge in two other columns, 3 x 0.7 and 3, or in two of nobody, 2 x 3 x 0.7 = 4.2 of the 7
        // that it needs; 2.75 times that is enough
        assertEquals(3 * 40, labelledOfThreeColumns(true));
    }

    @Test
    public void claimsCountForNoMoreWhereEventsCameBeforeAndFollow() {
        assertEquals(40, labelledOfThreeColumns(false));
    }

    @Test
    public void claimThatNoiseMayHaveIsNotEnoughInTheDark() {
        // a quarter of an event in each part: 22.8 of nobody's noise, more than 2.75 times 4.2
        noisePerUs = 0.25 / COLUMN_US;
        assertEquals(0, labelledOfThreeColumns(true));
    }

    @Test
    public void edgesAreTheirSegmentsInTheDark() {
        // each event meets its edge in nearly all of 16 parts, which counts 3 each
        noisePerUs = 0.25 / COLUMN_US;
        film(40, 1, 2);
        competition.decide(slices, 3, paths, 100_000, false);
        for (long i = slices.get(3).from; i < slices.get(3).until; i++) {
            assertEquals(1 + (int) (i & 1), window.segment[window.at(i)]);
        }
    }

    /**
     * Events without a label, of five pixels of an edge, that become those of segment 1. The edge goes along the motion
     * of that segment, which has the first row of it, but the other events have the label of another segment. If there
     * is a crowd, events of all pixels around have that label, too, ten times per 100 ms.
     */
    private int labelledAmongOthers(boolean isCrowd) {
        addPath(1, 100, 20);
        paths.get(0).see(151_000);
        for (int c = 0; c < 30; c++) {
            for (int y = 20; y < 40; y++) {
                int label = y == 20 ? 1 : c == 15 ? 0 : 2;
                window.give(window.add(c * COLUMN_US, 0, 20 + c, y, 1), label, label);
            }
            for (int place = 0; isCrowd && place < 96 * 64; place++) {
                window.give(window.add(c * COLUMN_US + 1, 0, place % 96, place / 96, 1), 2, 2);
            }
            endSlice((c + 1) * COLUMN_US);
        }
        competition.decide(slices, 3, paths, 200_000, false);
        int count = 0;
        for (long i = slices.get(3).from; i < slices.get(3).until; i++) {
            int k = window.at(i);
            count += window.timeUs[k] == 150_000 && window.y[k] > 22 && window.y[k] < 28 ? window.segment[k] : 0;
        }
        return count;
    }

    @Test
    public void eventsOfOthersAlongAMotionShowThatItsEdgeCameThere() {
        // 16 parts of 3 x 0.45 are 21.6, and nearly as much where others are rare: more than the 7 that are needed
        assertEquals(5, labelledAmongOthers(false));
    }

    @Test
    public void eventsOfOthersShowLittleWhereTheyAreEverywhere() {
        // 0.7 of an event are expected on each pixel in each part, eight on four pixels where they are three times as
        // dense: they count a ninth of that, 2.4
        assertEquals(0, labelledAmongOthers(true));
    }

    @Test
    public void eventThatNoMotionExplainsIsNoise() {
        film(30, 1, 2);
        int noise = 0;
        for (long i = slices.get(3).from; i < slices.get(3).until; i += 10, noise++) {
            // moved away from both edges, each by another way, and said to be of the first
            int k = window.at(i);
            window.x[k] = (short) (window.x[k] - 7 - noise * 5 % 11);
            window.give(k, 1, 1);
        }
        slices.set(3, new Slice(until(slices.get(3).until), SENSOR, slices.get(3).from,
            slices.get(3).fromUs, slices.get(3).untilUs, 0));
        competition.decide(slices, 3, paths, 100_000, false);
        int without = 0;
        for (long i = slices.get(3).from; i < slices.get(3).until; i += 10) {
            without += window.segment[window.at(i)] == 0 ? 1 : 0;
        }
        assertEquals(noise, without);
    }
}
