package io.github.sofas.flow.fit;

import static org.junit.Assert.assertEquals;

import io.github.sofas.flow.motion.Motion;
import java.util.Random;
import org.junit.Test;

public class PathPullTest {
    private static final double METRIC = 3_000;
    private static final double HALF_S = 0.1;
    private static final double RADIUS_PX = 10;
    /** Of what moves on straight: 3,000 times 0.1² / 3. */
    private static final double PULL = 10;

    private static final int OUTLINE = 150;
    private static final int EDGES = 50;

    private final PathPull pull = new PathPull();
    private final Motion motion = new Motion();

    /** Takes what moves to the right, and is found at the top of the metric, beside which that loses as much. */
    private void take(double vx, double ay, double found, double lossFound) {
        motion.set(0, vx, 0);
        motion.ay = ay;
        motion.omega = found;
        pull.take(new Parabola().along(0, lossFound, 1, 0), METRIC, motion, HALF_S, RADIUS_PX);
    }

    @Test
    public void whatMovesOnStraightTurnsFasterThanTheMetricTells() {
        // turning shifts the rim at 1e-3 px/s, so that all of it moves on
        take(100, 0, 1e-4, 100);
        assertEquals(90, pull.ownLoss(), 1e-3);
        // of the pull, which is 10 / 90 of the rotation, 1 / (1 + (20 / 90)²) is taken off
        assertEquals(1e-4 * (1 + 10 / 90.0 * 8100 / 8500), pull.freed(), 1e-9);
    }

    @Test
    public void halfIsTakenOffWhereItsOwnLossIsTwiceThePull() {
        take(100, 0, 1e-4, 3 * PULL);
        assertEquals(1e-4 * (1 + 0.5 / 2), pull.freed(), 1e-9);
    }

    @Test
    public void discWithoutTextureTurnsAsFound() {
        take(100, 0, 0.5, 0.9 * PULL);
        assertEquals(0, pull.ownLoss(), 0);
        assertEquals(0.5, pull.freed(), 0);
    }

    @Test
    public void whatTurnsOnTheSpotIsNotPulled() {
        take(0, 0, 2, 100);
        assertEquals(100, pull.ownLoss(), 0);
        assertEquals(2, pull.freed(), 0);
    }

    @Test
    public void whatMovesOnAsFastAsItsRimTurnsIsPulledByHalf() {
        take(20, 0, 2, 100);
        assertEquals(100 - PULL / 2, pull.ownLoss(), 1e-9);
    }

    @Test
    public void whatTurnsAsItsPathDoesIsNotPulled() {
        // 100 px/s to the right, 50 px/s² downwards: the path turns by half a rad per s
        take(100, 50, 0.5, 100);
        assertEquals(0.5, pull.freed(), 0);
    }

    /**
     * Adds what the outline of a disc gives, and edges on it of any direction, that moves at 80 px/s to the right and
     * turns at 2 rad/s, brought back along that.
     */
    private static void addDisc(MetricFit fit, double halfS, Random random) {
        for (int edge = 0; edge < OUTLINE + EDGES; edge++) {
            boolean isOutline = edge < OUTLINE;
            double radius = isOutline ? 12 : 10 * Math.sqrt(random.nextDouble());
            double at = 2 * Math.PI * random.nextDouble();
            double x = radius * Math.cos(at);
            double y = radius * Math.sin(at);
            double normal = isOutline ? at : 2 * Math.PI * random.nextDouble();
            for (double s = -halfS; s < halfS; s += halfS / 40) {
                double turned = 2 * s;
                // how squarely the edge moves, of which there are the more events
                double vx = 80 - 2 * (x * Math.sin(turned) + y * Math.cos(turned));
                double vy = 2 * (x * Math.cos(turned) - y * Math.sin(turned));
                double across = vx * Math.cos(normal + turned) + vy * Math.sin(normal + turned);
                if (random.nextDouble() < Math.abs(across) / 150) {
                    double along = 4 * (random.nextDouble() - 0.5);
                    float px = (float) (x - along * Math.sin(normal));
                    float py = (float) (y + along * Math.cos(normal));
                    fit.add(60 + px, 60 + py, (float) s, px, py, across > 0 ? 1 : -1);
                }
            }
        }
    }

    @Test
    public void rotationOfADiscThatMovesOnIsFreed() {
        double halfS = 0.0875;
        double found = 0;
        double freed = 0;
        int discs = 20;
        for (int seed = 0; seed < discs; seed++) {
            MetricFit fit = new MetricFit(120, 120, MetricFit.CELL_PX, 16_384, 0);
            addDisc(fit, halfS, new Random(seed));
            fit.frame(1 / halfS);
            VelocityTop top = fit.fit(0, 0, MetricFit.FLAT_SIGMAS);
            Parabola rotation = fit.changes().rotation(ChangeFit.APART_PX / (halfS * 12));
            motion.set(0, 80, 0);
            motion.omega = 2;
            pull.take(rotation, top.metric(), motion, halfS, 8.5);
            found += (2 + rotation.step()) / discs;
            freed += pull.freed() / discs;
        }
        assertEquals("found", 1.67, found, 0.05);
        assertEquals("freed", 2, freed, 0.1);
    }
}
