package io.github.sofas.flow.fit;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import io.github.sofas.flow.motion.Motion;
import java.util.Random;
import org.junit.Test;

/** The growth of dots whose picture is all but an upright edge, 20 px to the right of the centre. */
public class GrowthFitTest {
    private static final double RADIUS_PX = 20;
    /** Ten elevenths of the radius: a tenth of what shows may be noise. */
    private static final double FROM_PX = RADIUS_PX / 1.1;
    private static final double HALF_S = 1;

    private final GrowthFit growth = new GrowthFit();
    private final MetricFit fit = new MetricFit(128, 96, MetricFit.CELL_PX, 4096, 1900);
    private final StructureTensor structure = new StructureTensor();

    /** Adds dots around the centre that grow from where the edge is. */
    private void film(double its) {
        Random random = new Random(3);
        for (int dot = 0; dot < 40; dot++) {
            double rx = 40 * random.nextDouble() - 20;
            double ry = 40 * random.nextDouble() - 20;
            for (int k = 0; k < 12; k++) {
                float tau = (k + random.nextFloat() - 6) / 6;
                float x = (float) (rx + its * tau * (rx - FROM_PX));
                float y = (float) (ry + its * tau * ry);
                fit.add(64 + x, 48 + y, tau, x, y, 1);
            }
        }
        fit.frame(1);
        fit.fit(0, 0, MetricFit.FLAT_SIGMAS);
        structure.begin();
        structure.add(1, 0, 1, 0, 1, 0);
        structure.end();
    }

    @Test
    public void growthFromWhereItLooksLeastLikeAVelocityIsFoundWithThatOfTheCentre() {
        // 0.02 1/s shift the ends of the window by half a pixel
        film(0.02);
        growth.measure(fit, structure, 0, HALF_S, RADIUS_PX, false);
        assertEquals(0.02, growth.growth(), 0.01);
        assertEquals(growth.growth(), growth.step(), 0);
        // a pixel at the end of the window, at the root of 20² + 18.2² px
        assertEquals(1 / 27.03, growth.perPx(), 1e-4);
        Motion motion = new Motion();
        motion.set(0, 10, 5);
        growth.give(motion, 0.5);
        assertEquals(0.5, motion.growth, 0);
        assertEquals(10 - 0.5 * FROM_PX, motion.vx, 1e-3);
        assertEquals(5, motion.vy, 1e-3);
    }

    @Test
    public void aboutTheCentreIsLostWhatTheVelocityOfTheCentreLosesToo() {
        film(0);
        growth.measure(fit, structure, 0, HALF_S, RADIUS_PX, false);
        MotionLoss loss = new MotionLoss();
        loss.clear();
        double alone = growth.lossAboutCentre(loss);
        loss.xx = 3;
        assertTrue(alone > 0);
        assertEquals(alone + 3 * FROM_PX * FROM_PX, growth.lossAboutCentre(loss), 1);
    }
}
