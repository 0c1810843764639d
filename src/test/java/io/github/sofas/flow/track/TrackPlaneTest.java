package io.github.sofas.flow.track;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.flow.SofasParameters;
import org.junit.Test;

/** Whether two track planes that move as one are one. */
public class TrackPlaneTest {
    /** A plane without events, at 50 px/s from 0 s. */
    private static TrackPlane plane(int id) {
        TrackPlane plane = new TrackPlane(64, 64, SofasParameters.defaults());
        plane.start(id, 0, 50, 0);
        return plane;
    }

    @Test
    public void piecesAreOneAtOnce() {
        // 25 px after it was found
        assertTrue(plane(2).agreesFor(plane(1), 500_000));
    }

    @Test
    public void bodiesLongTrackedApartAreOneAfterEightPxTogether() {
        // 35 px after they were found; 8 px take 160 ms
        TrackPlane older = plane(1);
        TrackPlane plane = plane(2);
        for (int ms = 700; ms <= 900; ms += 20) {
            assertEquals("at " + ms + " ms", ms >= 860, plane.agreesFor(older, ms * 1_000L));
        }
    }

    @Test
    public void bodiesThatPartMeanwhileAreTwo() {
        TrackPlane older = plane(1);
        TrackPlane plane = plane(2);
        for (int ms = 700; ms <= 780; ms += 20) {
            assertFalse(plane.agreesFor(older, ms * 1_000L));
        }
        // not asked for 40 ms
        for (int ms = 820; ms <= 1_000; ms += 20) {
            assertEquals("at " + ms + " ms", ms >= 980, plane.agreesFor(older, ms * 1_000L));
        }
        assertFalse("with another", plane.agreesFor(plane(3), 1_010_000));
    }

    /** A plane at rest, on every pixel of a box in steps of two pixels, but for some columns. */
    private static TrackPlane box(int id, int left, int top, int right, int bottom, int emptyFrom) {
        TrackPlane plane = new TrackPlane(240, 64, SofasParameters.defaults());
        plane.start(id, 0, 0, 0);
        for (int x = left; x <= right; x += 2) {
            for (int y = top; y <= bottom; y += 2) {
                if (x < emptyFrom || x == right) {
                    plane.addPast(x, y, 0, 1);
                }
            }
        }
        return plane;
    }

    @Test
    public void missesWhatIsCoveredWhereItHasFewEventsInsideTheOther() {
        // of columns 2 to 202 the other covers 82 to 202, a share of 0.6, 87 to 202 of them by 5 px or more
        TrackPlane other = box(2, 82, 4, 220, 60, 240);
        // 58 columns inside, 43 outside: 1.35 to 1, where 1.5 to 1 is even and 1.2 to 1 is 0.8 of it
        TrackPlane seen = box(1, 2, 20, 202, 30, 240);
        seen.coverBy(other, 0);
        assertFalse(seen.missesWhatIsCovered());
        // 50 columns inside, 43 outside: 1.16 to 1
        TrackPlane hidden = box(1, 2, 20, 202, 30, 186);
        hidden.coverBy(other, 0);
        assertTrue(hidden.missesWhatIsCovered());
    }

    @Test
    public void missesWhatIsCoveredWhereTheOtherIsAllOverIt() {
        TrackPlane plane = box(1, 20, 20, 30, 30, 128);
        plane.coverBy(box(2, 0, 0, 60, 60, 128), 0);
        assertTrue(plane.missesWhatIsCovered());
        plane.uncover();
        assertTrue("nothing covers it", plane.missesWhatIsCovered());
    }
}
