package io.github.sofas.flow.paper;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import io.github.sofas.flow.PlainPlane.Event;
import io.github.sofas.flow.SofasParameters;
import java.util.ArrayList;
import java.util.List;
import org.junit.Test;

/** Association and refining cycles worked out by hand; velocityScale 100 px/s at 45 degrees. */
public class RefinementTest {
    private static final Numbers P = Numbers.of(SofasParameters.paper());

    private static Refinement refined(Numbers p, List<Event> events, int i, int j) {
        Refinement structure = new Refinement(p);
        int n = events.size();
        long[] time = new long[n];
        short[] x = new short[n];
        short[] y = new short[n];
        byte[] sign = new byte[n];
        for (int e = 0; e < n; e++) {
            time[e] = events.get(e).timeUs();
            x[e] = (short) events.get(e).x();
            y[e] = (short) events.get(e).y();
            sign[e] = (byte) events.get(e).polarity();
        }
        structure.load(time, x, y, sign, 0, n);
        structure.refine(i, j);
        return structure;
    }

    /** Events at time 0: what the digits of a picture say, each digit that many ON events; '-' one OFF event. */
    private static List<Event> picture(String... rows) {
        List<Event> events = new ArrayList<>();
        for (int y = 0; y < rows.length; y++) {
            for (int x = 0; x < rows[y].length(); x++) {
                char c = rows[y].charAt(x);
                int count = c == '.' ? 0 : c == '-' ? 1 : c - '0';
                for (int k = 0; k < count; k++) {
                    events.add(new Event(x, y, 0, c == '-' ? -1 : 1));
                }
            }
        }
        return events;
    }

    /** The members that lie on each cell, as a picture. */
    private static List<String> associated(Refinement structure, int width, int height) {
        int[][] count = new int[height][width];
        for (int i = 0; i < structure.loaded(); i++) {
            if (structure.contains(i)) {
                count[structure.y(i)][structure.x(i)]++;
            }
        }
        List<String> rows = new ArrayList<>();
        for (int[] row : count) {
            StringBuilder text = new StringBuilder();
            for (int c : row) {
                text.append(c == 0 ? "." : Integer.toString(c));
            }
            rows.add(text.toString());
        }
        return rows;
    }

    @Test
    public void cellsAboveTheThresholdAndAllThatAreConnectedAreAssociated() {
        // |f| of the 8 occupied cells: 5 1 1 1, 4, 1 1 1 (OFF counts by its amount). Sum 15, mean 1.875; squares
        // 25 + 16 + 6 = 47, 47/8 - 3.5156 = 2.3594, sd 1.536. w = 1: 3.41: the 5 and the 4 select. The corner and the
        // side join the 5; a gap of one column does not.
        Refinement structure = refined(Changed.of(P, "cycles", 1, "thresholdSd", 1), picture(
            "51..1.",
            "..1...",
            "...1..",
            "......",
            "4...1-"), 4, 4);
        // the 1 at (4, 0) is two columns from the 1 at (2, 1), and two rows from (3, 2)
        assertEquals(List.of(
            "51....",
            "..1...",
            "...1..",
            "......",
            "4....."), associated(structure, 6, 5));
        assertEquals(12, structure.size());
    }

    @Test
    public void cellThatIsJustAsGreatAsTheThresholdSelectsNothing() {
        // all alike: mean 2, sd 0; no cell is above
        assertEquals(0, refined(Changed.of(P, "cycles", 1), picture("2.2.2"), 4, 4).size());
        // w = 1 of the cells 1 and 3: mean 2, sd 1: 3 is not above 3; with w = 0.99 it is
        assertEquals(0, refined(Changed.of(P, "cycles", 1, "thresholdSd", 1), picture("1..3"), 4, 4).size());
        assertEquals(3, refined(Changed.of(P, "cycles", 1, "thresholdSd", 0.99), picture("1..3"), 4, 4).size());
    }

    @Test
    public void votesThatCancelLeaveTheirCellEmpty() {
        // ON and OFF on (1, 0): f = 0, so that (2, 0) is not connected to the 3, which is above the mean of 3 and 1
        List<Event> events = new ArrayList<>(picture("311"));
        events.add(new Event(1, 0, 0, -1));
        Refinement structure = refined(Changed.of(P, "cycles", 1, "thresholdSd", 0), events, 4, 4);
        assertEquals(List.of("3.."), associated(structure, 3, 1));
    }

    @Test
    public void refiningCycleFindsTheVelocityBetweenTwoProjections() {
        // One row in five columns moves right at 44.5 px/s, 24 degrees, a column every 22,472 us. The widest range has
        // 20 degrees (36.4 px/s) and 40; the second cycle 20 + 2.222 i: 24.44 degrees (45.5 px/s) is the nearest.
        List<Event> events = new ArrayList<>();
        for (int c = 0; c < 12; c++) {
            for (int y = 0; y < 12; y++) {
                events.add(new Event(c, y, Math.round(c / 44.5e-6), 1));
            }
        }
        events.add(new Event(11, 0, Math.round(11 / 44.5e-6), 1));
        Refinement twice = refined(Changed.of(P, "cycles", 2, "lifespanUs", 500_000), events, 5, 4);
        assertEquals(20 + 2 * 20.0 / 9, twice.angleX(), 1e-9);
        assertEquals(0, twice.angleY(), 0);
        assertEquals(145, twice.size());
    }

    @Test
    public void refinementTiesGoToTheSlowest() {
        // events of one moment: every projection has the same metric, and the slowest of 20 + 2.222 i degrees in x
        // and 0 + 2.222 j in y is 11.11 and 0
        Refinement structure = refined(Changed.of(P, "cycles", 2), picture("3111"), 5, 4);
        assertEquals(20 - 4 * 20.0 / 9, structure.angleX(), 1e-9);
        assertEquals(0, structure.angleY(), 0);
    }

    @Test
    public void refinedAngleStaysShortOfTheRightAngle() {
        // A block of four columns moves left at 850 px/s, which is what 96.7 degrees would be. From the last of 31
        // projections, 87.1 degrees, a range of 20 degrees reaches 96.8: infinitely fast to the right is no way to
        // the left.
        List<Event> events = new ArrayList<>();
        for (int k = 0; k < 20; k++) {
            for (int x = 0; x < 4; x++) {
                events.add(new Event(35 - k + x, 5, k * 1176L, 1));
            }
        }
        events.add(new Event(16, 5, 19 * 1176L, 1));
        Refinement structure = refined(Changed.of(P, "flowProjections", 31, "cycles", 2), events, 30, 15);
        assertTrue("angle " + structure.angleX(), structure.angleX() > 70 && structure.angleX() <= 89);
    }

    @Test
    public void projectionThatSpreadsTheEventsBeyondAPlaneHoldsNoStructure() {
        // 15 of 31 steps of 5.8 degrees, 87.1, are 1,972 px/s: over 10 s a plane of 19,500 px
        List<Event> events = new ArrayList<>();
        for (int i = 0; i < 100; i++) {
            events.add(new Event(5, 5, i * 100_000L, 1));
        }
        events.add(new Event(30, 20, 9_900_000, 1));
        Numbers p = Changed.of(P, "lifespanUs", 60_000_000, "cycles", 1, "thresholdSd", 0);
        assertEquals(0, refined(Changed.of(p, "rangeDeg", 180, "flowProjections", 31), events, 30, 30).size());
        assertEquals(100, refined(Changed.of(p, "flowProjections", 9), events, 4, 4).size());
    }
}
