package io.github.sofas.flow.track;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import io.github.sofas.flow.motion.Motion;
import org.junit.Test;

/** A lost structure in a new one. */
public class ReappearanceTest {
    private static final long LOST_US = 200_000;
    private static final long NOW_US = 300_000;

    private static Motion motion(long timeUs, double vx, double vy) {
        Motion motion = new Motion();
        motion.set(timeUs, vx, vy);
        return motion;
    }

    /** An upright box of 20 x 20 px with its left upper corner at (60, 40) when it was seen last, at 100 px/s. */
    private static Shape box() {
        Shape shape = new Shape(128, 96);
        shape.start(motion(LOST_US, 100, 0));
        shape.follow(motion(LOST_US, 100, 0), 1_000_000);
        for (int i = 0; i < 20; i++) {
            shape.see(60, 40 + i, LOST_US);
            shape.see(79, 40 + i, LOST_US);
            shape.see(60 + i, 40, LOST_US);
            shape.see(60 + i, 59, LOST_US);
        }
        return shape;
    }

    /** A new upright edge of 16 px with its upper end at (x, y). */
    private static Reappearance edge(int x, int y) {
        LiveEvents live = new LiveEvents();
        Contour contour = new Contour(128, 96, 0.15);
        contour.project(live, motion(NOW_US, 0, 0));
        for (int i = 0; i < 16; i++) {
            contour.add(live, live.add(x, y + i, NOW_US, 1, false, false));
        }
        Reappearance reappearance = new Reappearance();
        reappearance.load(live, contour);
        return reappearance;
    }

    @Test
    public void edgeOfABodyThatStoppedLiesOnItsShapeFartherBack() {
        // the box is thought to be 10 px on, with its left edge at 70; it stopped, and the edge is at 60
        Shape shape = box();
        Reappearance reappearance = edge(60, 42);
        assertEquals(1, reappearance.search(shape, motion(LOST_US, 100, 0), 10, NOW_US), 0);
        assertEquals(-10, reappearance.shiftX(), 1);
        shape.move(reappearance.shiftX(), reappearance.shiftY(), motion(NOW_US, -50, 0), 1_000_000);
        // and now its right edge is known at 79, and 5 px less after 0.1 s
        assertTrue(shape.wasSeen(79, 50, NOW_US));
        assertTrue(shape.wasSeen(74, 50, NOW_US + 100_000));
    }

    @Test
    public void edgeAheadOfABodyIsNotIts() {
        // 20 px right of where the box's right edge is thought to be
        assertEquals(0, edge(109, 42).search(box(), motion(LOST_US, 100, 0), 10, NOW_US), 0);
    }

    @Test
    public void edgeLongerThanABodyIsOnlyPartlyIts() {
        // upper end 10 px above the box: 6 px of 16 on it, or up to 4 px more, for it may lie that far beside its path
        double share = edge(70, 30).search(box(), motion(LOST_US, 100, 0), 10, NOW_US);
        assertTrue("share " + share, share >= 6 / 16.0 && share <= 11 / 16.0);
    }
}
