package io.github.sofas.flow.fit;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.Random;
import org.junit.Test;

/** Changes of the motion of dots, by projections and by slopes, and whether they show within parts of them. */
public class ChangeFitTest {
    /** Dots in one or more boxes beside the centre of rotation, seen twelve times in two seconds each. */
    private static MetricFit dots(double[][] boxes, double[][] velocities, double omega, double alpha, double growth) {
        Random random = new Random(3);
        MetricFit fit = new MetricFit(128, 96, MetricFit.CELL_PX, 4096, 1900);
        for (int b = 0; b < boxes.length; b++) {
            for (int d = 0; d < 40; d++) {
                double rx = boxes[b][0] + (boxes[b][2] - boxes[b][0]) * random.nextDouble();
                double ry = boxes[b][1] + (boxes[b][3] - boxes[b][1]) * random.nextDouble();
                for (int k = 0; k < 12; k++) {
                    float tau = (k + random.nextFloat() - 6) / 6;
                    double turned = (omega + alpha * tau / 2) * tau;
                    double x = rx + velocities[b][0] * tau + growth * tau * rx - turned * ry;
                    double y = ry + velocities[b][1] * tau + growth * tau * ry + turned * rx;
                    fit.add((float) (64 + x), (float) (48 + y), tau, (float) x, (float) y, 1);
                }
            }
        }
        fit.frame(1);
        fit.fit(0, 0, MetricFit.FLAT_SIGMAS);
        return fit;
    }

    /** A box of 40 px around the centre whose dots have a rotation, a change of it, and a growth. */
    private static MetricFit changing(double omega, double alpha, double growth) {
        return dots(new double[][] {{-20, -20, 20, 20}}, new double[][] {{0, 0}}, omega, alpha, growth);
    }

    @Test
    public void eachChangeIsSteppedToByItself() {
        // 0.04 per s shift the ends of the window by 0.8 px at 20 px; neighbours are twice as far
        MetricFit turns = changing(0.04, 0, 0);
        assertEquals(0.04, turns.changes().rotation(0.08).step(), 0.01);
        assertEquals(0, turns.changes().growth(0.08).step(), 0.01);
        MetricFit grows = changing(0, 0, -0.04);
        assertEquals(-0.04, grows.changes().growth(0.08).step(), 0.01);
        assertEquals(0, grows.changes().rotation(0.08).step(), 0.01);
        // half of 0.08 per s², from a second before to a second after
        MetricFit spins = changing(0, 0.08, 0);
        assertEquals(0.08, spins.changes().spin(0.16).step(), 0.02);
        assertEquals(0, spins.changes().rotation(0.08).step(), 0.01);
    }

    @Test
    public void growthFromAPlaceBesideTheCentreIsThatWithTheVelocityThatHoldsThePlace() {
        // from 15 px to the right and 10 px up a growth of 0.04 per s moves the centre to the left by 0.6, down by 0.4
        MetricFit grows = dots(new double[][] {{-20, -20, 20, 20}}, new double[][] {{-0.6, 0.4}}, 0, 0, 0.04);
        grows.growFrom(15, -10);
        Parabola fitted = grows.changes().growth(0.08);
        assertEquals(0.04, fitted.step(), 0.01);
        assertTrue("as an evident growth has it", grows.localEvidence(0, 0.04, 0, 0.04) > 0);
        grows.clear();
        assertEquals("all is forgotten", 0, grows.changes().growth(0.08).step(), 0);
    }

    @Test
    public void eachChangeIsSteppedToBySlopes() {
        // 0.02 per s shift the ends of the window by 0.4 px at 20 px; a step goes about half of the way or more
        MetricFit turns = changing(0.02, 0, 0);
        turns.fitSlopes(1, MetricFit.FLAT_SIGMAS);
        assertEquals(0.014, turns.changes().rotation(0.08).step(), 0.006);
        assertEquals(0, turns.changes().growth(0.08).step(), 0.002);
        MetricFit grows = changing(0, 0, -0.02);
        grows.fitSlopes(1, MetricFit.FLAT_SIGMAS);
        assertEquals(-0.014, grows.changes().growth(0.08).step(), 0.006);
        assertEquals(0, grows.changes().rotation(0.08).step(), 0.002);
        // half of 0.04 per s², from a second before to a second after
        MetricFit spins = changing(0, 0.04, 0);
        spins.fitSlopes(1, MetricFit.FLAT_SIGMAS);
        assertEquals(0.028, spins.changes().spin(0.16).step(), 0.012);
        assertEquals(0, spins.changes().rotation(0.08).step(), 0.002);
    }

    @Test
    public void whatIsOnOnePlaceKnowsNoGrowthAndNoRotation() {
        MetricFit point = dots(new double[][] {{0, 0, 0, 0}}, new double[][] {{0, 0}}, 0, 0, 0);
        assertEquals(0, point.changes().growth(0.1).step(), 0);
        assertEquals(0, point.changes().growth(0.1).loss(), 0);
        assertEquals(0, point.changes().spin(0.1).step(), 0);
        assertEquals(0, point.changes().spin(0.1).loss(), 0);
    }

    @Test
    public void turningAndGrowingOfOneBodyShowsWithinItsParts() {
        assertTrue(changing(0.1, 0, 0).localEvidence(0.1, 0, 0.1, 0) > 1);
        assertTrue(changing(0, 0, 0.1).localEvidence(0, 0.1, 0, 0.1) > 1);
        // of the wrong sign it speaks against
        assertTrue(changing(0.1, 0, 0).localEvidence(-0.1, 0, -0.1, 0) < 0);
    }

    @Test
    public void twoBodiesThatComeApartOrPassEachOtherDoNotGrowOrTurn() {
        // 20 px left and right of the centre, 8 px wide and high: at 0.2 per s of growth 4 px/s left and right
        double[][] boxes = {{-24, -4, -16, 4}, {16, -4, 24, 4}};
        MetricFit apart = dots(boxes, new double[][] {{-4, 0}, {4, 0}}, 0, 0, 0);
        assertTrue(apart.localEvidence(0, 0.2, 0, 0.2) < 0);
        MetricFit past = dots(boxes, new double[][] {{0, -4}, {0, 4}}, 0, 0, 0);
        assertTrue(past.localEvidence(0.2, 0, 0.2, 0) < 0);
    }

    @Test
    public void noRotationAndNoGrowthAreNoEvidence() {
        assertEquals(0, changing(0.1, 0, 0.1).localEvidence(0, 0, 0, 0), 0);
    }
}
