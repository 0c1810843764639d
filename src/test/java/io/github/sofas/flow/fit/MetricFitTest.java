package io.github.sofas.flow.fit;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.flow.PlainPlane.Cell;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.junit.Test;

/** The metric of bilinear votes against a plain one: twice the sum over all pairs of events of what they share. */
public class MetricFitTest {
    private static final double SLANT = 0.577;

    /** An event at (x, y) px, tau s after the reference. */
    private record Vote(float x, float y, float tauS, int polarity) {
    }

    private static double fast(List<Vote> votes, double cellPx, double vx, double vy) {
        MetricFit fit = new MetricFit(32, 24, cellPx, 4096, 1900);
        for (Vote v : votes) {
            fit.add(v.x, v.y, v.tauS, 0, 0, v.polarity);
        }
        // nine projections with no distance between them
        fit.frame(0);
        return fit.fit(vx, vy, 0).metric();
    }

    private static double plain(List<Vote> votes, double cellPx, double vx, double vy) {
        // votes that cancel more than they meet are as good as none
        return Math.max(0, (plain(votes, cellPx, vx, vy, 0) + plain(votes, cellPx, vx, vy, 8)) / 2);
    }

    /** On a grid that is shifted by some sixteenths of a cell. */
    private static double plain(List<Vote> votes, double cellPx, double vx, double vy, int shift) {
        List<Map<Cell, Integer>> cells = new ArrayList<>();
        for (Vote v : votes) {
            cells.add(bilinear(sixteenths(v.x, vx * v.tauS, cellPx) + shift,
                sixteenths(v.y, vy * v.tauS, cellPx) + shift));
        }
        long sum = 0;
        for (int i = 0; i < votes.size(); i++) {
            for (int j = i + 1; j < votes.size(); j++) {
                for (Map.Entry<Cell, Integer> mine : cells.get(i).entrySet()) {
                    sum += (long) votes.get(i).polarity * votes.get(j).polarity * mine.getValue()
                        * cells.get(j).getOrDefault(mine.getKey(), 0);
                }
            }
        }
        return 2.0 * sum / (256 * 256);
    }

    /** Place in sixteenths of a cell, of a place and a shift that are each rounded to the nearest. */
    private static long sixteenths(double px, double shiftPx, double cellPx) {
        return (long) (Math.floor(px / cellPx * 16 + 0.5) - Math.floor(shiftPx / cellPx * 16 + 0.5));
    }

    /** Votes for the four cells around, in 1/256. */
    private static Map<Cell, Integer> bilinear(long x16, long y16) {
        Map<Cell, Integer> votes = new HashMap<>();
        long cx = Math.floorDiv(x16, 16L);
        long cy = Math.floorDiv(y16, 16L);
        int fx = (int) Math.floorMod(x16, 16L);
        int fy = (int) Math.floorMod(y16, 16L);
        votes.put(new Cell(cx, cy), (16 - fx) * (16 - fy));
        votes.put(new Cell(cx + 1, cy), fx * (16 - fy));
        votes.put(new Cell(cx, cy + 1), (16 - fx) * fy);
        votes.put(new Cell(cx + 1, cy + 1), fx * fy);
        return votes;
    }

    @Test
    public void eventThatIsAddedLaterCounts() {
        MetricFit fit = new MetricFit(32, 24, 1, 4096, 1900);
        fit.add(5, 5, -0.1f, 0, 0, 1);
        fit.add(7, 5, 0.1f, 0, 0, 1);
        // 2 px in 0.2 s: they meet wholly at 10 px/s, not where they are
        assertEquals(0, fit.metric(), 0);
        double two = fit.metric(10, 0);
        assertEquals(plain(List.of(new Vote(5, 5, -0.1f, 1), new Vote(7, 5, 0.1f, 1)), 1, 10, 0), two, 1e-9);
        // a third one far off the box of the two, which meets none, and a fourth one on it
        fit.add(25, 20, 0.2f, 0, 0, 1);
        assertEquals(two, fit.metric(10, 0), 1e-9);
        fit.add(21, 20, -0.2f, 0, 0, 1);
        assertEquals(plain(List.of(new Vote(5, 5, -0.1f, 1), new Vote(7, 5, 0.1f, 1), new Vote(25, 20, 0.2f, 1),
            new Vote(21, 20, -0.2f, 1)), 1, 10, 0), fit.metric(10, 0), 1e-9);
        assertTrue(fit.metric(10, 0) > 1.5 * two);
    }

    @Test
    public void metricIsTwiceTheSumOverAllPairs() {
        Random random = new Random(7);
        for (int run = 0; run < 60; run++) {
            List<Vote> votes = new ArrayList<>();
            int count = 2 + random.nextInt(150);
            for (int i = 0; i < count; i++) {
                // places and times without a rounding of their own in single precision
                float x = random.nextInt(32 * 64) / 64f;
                float y = random.nextInt(24 * 64) / 64f;
                float tau = (random.nextInt(256) - 128) / 256f;
                votes.add(new Vote(x, y, tau, random.nextInt(4) == 0 ? -1 : 1));
            }
            double cellPx = 1 << random.nextInt(2);
            double vx = (random.nextInt(320) - 160) / 16.0 * cellPx;
            double vy = (random.nextInt(320) - 160) / 16.0 * cellPx;
            assertEquals("run " + run, plain(votes, cellPx, vx, vy), fast(votes, cellPx, vx, vy), 0);
        }
    }

    @Test
    public void loneEventMeetsNobody() {
        assertEquals(0, fast(List.of(new Vote(3, 3, 0, 1)), 1, 0, 0), 0);
        assertEquals(0, fast(List.of(new Vote(3, 3, 0, 1), new Vote(9, 3, 0, 1)), 1, 0, 0), 0);
    }

    @Test
    public void twoEventsAtOnePlaceMeetAsMuchInACellAsBetweenTwo() {
        // 2 w f with f = 1 on one grid; on the other, between cells, the four quarters meet: 2 * 4 * 1/16
        assertEquals((2 + 0.5) / 2, fast(List.of(new Vote(3, 3, 0, 1), new Vote(3, 3, 0, 1)), 1, 0, 0), 0);
        assertEquals((0.5 + 2) / 2, fast(List.of(new Vote(3.5f, 3.5f, 0, 1), new Vote(3.5f, 3.5f, 0, 1)), 1, 0, 0), 0);
        assertEquals(0, fast(List.of(new Vote(3, 3, 0, 1), new Vote(3, 3, 0, -1)), 1, 0, 0), 0);
    }

    @Test
    public void manyEventsVoteOnOneGrid() {
        // each of 2,000 meets the 1,999 others
        assertEquals(2_000 * 1_999, fast(Collections.nCopies(2_000, new Vote(3, 3, 0, 1)), 1, 0, 0), 0);
    }

    @Test
    public void eventsOfOppositePolarityCancel() {
        // four ON, one OFF: six pairs of ON, four mixed ones; a pair meets by 1 on one grid, by 1/4 on the other
        Vote on = new Vote(3, 3, 0, 1);
        assertEquals(2 * (6 - 4) * (1 + 0.25) / 2, fast(List.of(on, on, new Vote(3, 3, 0, -1), on, on), 1, 0, 0), 0);
    }

    @Test
    public void eventsOfOneMovingPointMeetAtItsVelocity() {
        // 8 px/s to the right: 3 events, 3 pairs; elsewhere none
        List<Vote> votes = List.of(new Vote(3, 3, 0, 1), new Vote(7, 3, 0.5f, 1), new Vote(11, 3, 1, 1));
        assertEquals(2 * 3 * (1 + 0.25) / 2, fast(votes, 1, 8, 0), 0);
        assertEquals(0, fast(votes, 1, 0, 0), 0);
        assertEquals(0, fast(votes, 1, -8, 0), 0);
    }

    @Test
    public void eventThatLeavesThePlaneMeetsNobody() {
        // 1000 px/s for a second: beyond the border of 20 cells; at rest six pairs
        List<Vote> votes = List.of(new Vote(3, 3, -1, 1), new Vote(3, 3, -1, 1), new Vote(3, 3, 1, 1),
            new Vote(3, 3, 1, 1));
        assertEquals(0, fast(votes, 1, 1000, 0), 0);
        assertEquals(2 * 6 * (1 + 0.25) / 2, fast(votes, 1, 0, 0), 0);
    }

    @Test
    public void stepLeadsToTheVelocityOfAMovingPattern() {
        // dots at chance places, each fires eight times in a second at (12, -5) px/s; from (10, -4) to the top
        Random random = new Random(3);
        MetricFit fit = new MetricFit(64, 48, 1, 4096, 1900);
        for (int d = 0; d < 40; d++) {
            float x = 10 + 40 * random.nextFloat();
            float y = 10 + 28 * random.nextFloat();
            for (int k = 0; k < 8; k++) {
                float tau = (k - 3.5f + random.nextFloat() - 0.5f) / 8;
                fit.add(x + 12 * tau, y - 5 * tau, tau, 0, 0, 1);
            }
        }
        fit.frame(2);
        double vx = 10;
        double vy = -4;
        for (int c = 0; c < 5; c++) {
            VelocityTop top = fit.fit(vx, vy, 2);
            vx += top.stepX();
            vy += top.stepY();
        }
        assertEquals(12, vx, 0.1);
        assertEquals(-5, vy, 0.1);
    }

    @Test
    public void neighboursOfFewEventsLoseMoreThanNoiseDoes() {
        assertEquals(0.04, MetricFit.neighbourLoss(10_000), 0);
        assertEquals("2.5 standard deviations of 10", 0.25, MetricFit.neighbourLoss(100), 0);
        assertEquals(0.4, MetricFit.neighbourLoss(4), 0);
        assertEquals(0.4, MetricFit.neighbourLoss(0), 0);
    }

    @Test
    public void slopeIsToldInStandardDeviationsAlongTheSteeperAxis() {
        ProjectionFrame frame = new ProjectionFrame();
        frame.set(1);
        VelocityTop top = new VelocityTop().of(frame, 400, 8, -30, -100, -100, 0, MetricFit.FLAT_SIGMAS);
        assertEquals(30 / 20.0, top.slopeSigmas(), 1e-9);
    }

    @Test
    public void crossStepsToTheTopOfTheParabolasThroughItsFive() {
        // 60 points that move at (0.2, -0.1) px/s and are each seen 20 times in 8 s
        Random random = new Random(3);
        List<Vote> votes = new ArrayList<>();
        MetricFit fit = new MetricFit(32, 24, 1.3, 4096, 1900);
        for (int point = 0; point < 60; point++) {
            float x = 4 + 24 * random.nextFloat();
            float y = 4 + 16 * random.nextFloat();
            for (int i = 0; i < 20; i++) {
                float tau = 8 * (random.nextFloat() - 0.5f);
                votes.add(new Vote(x + 0.2f * tau, y - 0.1f * tau, tau, 1));
                fit.add(x + 0.2f * tau, y - 0.1f * tau, tau, 0, 0, 1);
            }
        }
        double h = 0.4;
        fit.frame(h);
        VelocityTop top = fit.fitCross(0, 0, 0);
        double here = fast(votes, 1.3, 0, 0);
        double left = fast(votes, 1.3, -h, 0);
        double right = fast(votes, 1.3, h, 0);
        double up = fast(votes, 1.3, 0, -h);
        double down = fast(votes, 1.3, 0, h);
        assertEquals(h * (right - left) / 2 / (2 * here - left - right), top.stepX(), 1e-9);
        assertEquals(h * (down - up) / 2 / (2 * here - up - down), top.stepY(), 1e-9);
        assertEquals((2 * here - left - right) / 2 / (h * h), top.lossXx(), 1e-6);
        assertEquals(right, top.metric(), 0);
    }

    @Test
    public void crossLiesAroundTheVelocityItIsGiven() {
        // events of a point that moves at (3, -2) px/s: around that velocity there is no step to take, around
        // (3.2, -2) one to the left
        MetricFit fit = new MetricFit(32, 24, 1.3, 64, 1900);
        for (int i = -8; i <= 8; i++) {
            float tau = i / 8f;
            fit.add(16 + 3 * tau, 12 - 2 * tau, tau, 0, 0, 1);
        }
        fit.frame(1);
        VelocityTop top = fit.fitCross(3, -2, 0);
        assertEquals(0, top.stepX(), 0.05);
        assertEquals(0, top.stepY(), 0.05);
        top = fit.fitCross(3.2, -2, 0);
        assertEquals(-0.2, top.stepX(), 0.1);
        assertEquals(0, top.stepY(), 0.05);
    }

    @Test
    public void whatHasGoneLessThanHalfAsFarIsSharperAtRest() {
        // points seen over a second that move by 2 px, and by 6 px: moved back by 6 px a second, the first ones are
        // spread over 4 px instead of 2, the second ones over none instead of 6
        for (int travelPx = 2; travelPx <= 6; travelPx += 4) {
            MetricFit fit = new MetricFit(32, 24, 1.3, 256, 1900);
            for (int point = 0; point < 5; point++) {
                for (int i = -8; i <= 8; i++) {
                    float tau = i / 16f;
                    fit.add(16 + travelPx * tau, 4 + 4 * point, tau, 0, 0, 1);
                }
            }
            assertEquals(travelPx == 2, fit.isSharperAtRest(6, 0));
        }
    }

    /** Fits the velocity of 60 points by slopes, each seen 40 times in two seconds at a velocity. */
    private static VelocityTop slopesOfPoints(double vx, double vy) {
        Random random = new Random(3);
        MetricFit fit = new MetricFit(64, 48, MetricFit.CELL_PX, 4096, 1900);
        for (int point = 0; point < 60; point++) {
            double x = 8 + 48 * random.nextDouble();
            double y = 8 + 32 * random.nextDouble();
            for (int i = 0; i < 40; i++) {
                double tau = 2 * random.nextDouble() - 1;
                fit.add((float) (x + vx * tau), (float) (y + vy * tau), (float) tau, 0, 0, 1);
            }
        }
        fit.frame(0.7);
        return fit.fitSlopes(1, MetricFit.FLAT_SIGMAS);
    }

    @Test
    public void slopesLeadTowardsTheTop() {
        // points are as sharp as structures can be: a step goes about half of the way, of what is
        // blurred all of it
        VelocityTop top = slopesOfPoints(0.2, -0.1);
        assertEquals(0.14, top.stepX(), 0.06);
        assertEquals(-0.07, top.stepY(), 0.03);
        top = slopesOfPoints(0, 0);
        assertEquals(0, top.stepX(), 0.01);
        assertEquals(0, top.stepY(), 0.01);
    }

    @Test
    public void edgeIsAskedAlongItselfAtNeighboursFarApart() {
        // an upright edge of 30 px, seen along each row again and again: by one look all slopes, by two the neighbours
        MetricFit fit = new MetricFit(64, 48, MetricFit.CELL_PX, 4096, 0);
        Random random = new Random(3);
        for (int i = 0; i < 2000; i++) {
            fit.add(32 + random.nextFloat(), 8 + 30 * random.nextFloat(), 2 * random.nextFloat() - 1, 0, 0, 1);
        }
        fit.frame(1, 0.1, 0, 0, MetricFit.NEIGHBOUR_LOSS, 1);
        assertTrue(fit.isBroad(1));
        long before = fit.votes();
        VelocityTop top = fit.fitSlopes(1, MetricFit.FLAT_SIGMAS);
        assertEquals(3 * fit.size(), fit.votes() - before);
        assertEquals("axis", 1, Math.abs(top.axisX()), 1e-3);
        assertTrue(top.lossYy() < 0.05 * top.lossXx());
    }

    @Test
    public void eventsFarOffTheSensorTellNothing() {
        // as far as the cells beside the sensor go, and farther
        MetricFit fit = new MetricFit(32, 24, MetricFit.CELL_PX, 4096, 1900);
        for (int x = -80; x < 110; x++) {
            for (int y = -60; y < 90; y += 10) {
                fit.add(x + 0.6f, y + 0.6f, x / 100f, x - 16, y - 12, 1);
            }
        }
        fit.frame(1);
        VelocityTop top = fit.fitSlopes(1, MetricFit.FLAT_SIGMAS);
        assertTrue(Double.isFinite(top.stepX()));
        assertTrue(Double.isFinite(top.lossXx()));
        assertTrue(Double.isFinite(fit.changes().growth(0.1).step()));
    }

    private static void assertNothingIsKnown(MetricFit fit, VelocityTop top) {
        assertEquals(0, top.metric(), 0);
        assertEquals(0, top.stepX(), 0);
        assertEquals(0, top.stepY(), 0);
        assertEquals(0, top.lossXx(), 0);
        assertEquals(0, top.lossYy(), 0);
        assertEquals(0, fit.changes().acceleration(1, 0, 1).step(), 0);
        assertEquals(0, fit.changes().rotation(1).step(), 0);
        assertEquals(0, fit.changes().growth(1).step(), 0);
        assertEquals(0, fit.changes().spin(1).step(), 0);
    }

    @Test
    public void eventsThatNeverMeetTellNoVelocity() {
        MetricFit fit = new MetricFit(32, 24, 1, 16, 1900);
        fit.add(4, 4, -1, 0, 0, 1);
        fit.add(24, 18, 1, 0, 0, 1);
        fit.frame(1);
        assertNothingIsKnown(fit, fit.fit(0, 0, 2));
        assertNothingIsKnown(fit, fit.fitCross(0, 0, 2));
    }

    @Test
    public void eventsThatOnlyCancelTellAFiniteVelocity() {
        // of opposite polarity at one place and time: at any velocity the metric is less than none
        MetricFit fit = new MetricFit(32, 24, 1, 16, 1900);
        fit.add(4, 4, 0.5f, 1, 1, 1);
        fit.add(4, 4, 0.5f, 1, 1, -1);
        fit.frame(1);
        assertEquals(0, fit.fitCross(0, 0, 2).metric(), 0);
        assertTrue(Double.isFinite(fit.changes().acceleration(1, 0, 1).step()));
        fit.frame(0, 1, 0, 1, 0.04, 1);
        VelocityTop top = fit.fitCross(0, 0, 2);
        assertTrue(Double.isFinite(top.stepX()));
        assertTrue(Double.isFinite(top.stepY()));
    }

    /** A straight edge with an upper end in row 30 that slides to the right by 100 px/s and comes in slanted. */
    private static MetricFit slantedEdgeThatComesIn() {
        MetricFit fit = new MetricFit(64, 96, MetricFit.CELL_PX, 4096, 1900);
        for (int y = 30; y < 96; y++) {
            for (int x = 0; x < 64; x++) {
                double s = (x + 10 + SLANT * (y - 48)) / 100;
                if (s >= 0 && s < 0.2) {
                    fit.add(x, y, (float) (s - 0.1), 0, 0, 1);
                }
            }
        }
        return fit;
    }

    @Test
    public void edgeThatTheBorderCutsOffMeetsMoreOftenAsItMovesThanAsItsEndAtTheBorder() {
        MetricFit fit = slantedEdgeThatComesIn();
        // that end slides along the border, where 0 = 100 s - 10 - SLANT (y - 48)
        double ofEnd = 100 / SLANT;
        assertTrue(fit.metric(0, ofEnd) > 1.05 * fit.metric(100, 0));
        fit.cutOff(0, 0, 0.1);
        assertTrue(fit.metric(0, ofEnd) < 0.8 * fit.metric(100, 0));
    }

    @Test
    public void metricAsSeenIsThatWithoutABorder() {
        MetricFit fit = slantedEdgeThatComesIn();
        double seen = fit.metric(100, 0);
        fit.cutOff(0, 0, 0.1);
        assertEquals(seen, fit.metricAsSeen(100, 0), 0);
        assertTrue(fit.metric(100, 0) > seen);
    }

    @Test
    public void borderIsTwoPixelsWide() {
        MetricFit fit = new MetricFit(64, 96, MetricFit.CELL_PX, 16, 16);
        assertTrue(fit.isAtBorder(1, 50));
        assertTrue(fit.isAtBorder(30, 94));
        assertFalse(fit.isAtBorder(2, 93));
    }
}
