package io.github.sofas.flow;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

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
}
