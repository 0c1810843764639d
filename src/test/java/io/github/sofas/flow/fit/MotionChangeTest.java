package io.github.sofas.flow.fit;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import io.github.sofas.flow.SofasParameters;
import io.github.sofas.flow.motion.Deformation;
import io.github.sofas.flow.motion.Motion;
import io.github.sofas.flow.motion.PlainMotion;
import io.github.sofas.flow.motion.PlainMotion.Place;
import io.github.sofas.flow.motion.SteppedProjection;
import java.util.List;
import java.util.Random;
import org.junit.Test;

/** Changes of the motion of a cloud of dots around (50, 40), each seen twenty times in a window of 0.2 s. */
public class MotionChangeTest {
    private static final double HALF_S = 0.1;
    private static final double RADIUS_PX = 20;
    private static final SofasParameters DEFAULTS = SofasParameters.defaults();

    private final MotionChange change = new MotionChange();
    private final MotionLoss loss = new MotionLoss();

    /** What moves at (100, 0) px/s in the middle of the window. */
    private static Motion steady() {
        Motion motion = new Motion();
        motion.set(0, 100, 0);
        motion.centreX = 50;
        motion.centreY = 40;
        return motion;
    }

    /** Metrics on two grids that each measurement asked for last, with half a one for a structure tensor. */
    private final int[] looks = new int[40];
    private int repeats = 8;
    /** Whether the events of a cloud are told to be of one polarity. */
    private boolean isOfOnePolarity;

    /** Measures a cloud of 40 px some times, starting from the velocity that is right in the middle of the window. */
    private Motion measured(Motion truth, SofasParameters p) {
        return measured(new Motion[] {truth}, new double[] {50}, RADIUS_PX, p);
    }

    /** The same of one or more clouds of so many px around, side by side. */
    private Motion measured(Motion[] truth, double[] middles, double reach, SofasParameters p) {
        Motion motion = steady();
        change.restart();
        loss.clear();
        for (int repeat = 0; repeat < repeats; repeat++) {
            MetricFit fit = fitted(motion, truth, middles, reach);
            long before = fit.votes();
            change.measure(fit, motion, loss, HALF_S, RADIUS_PX, isOfOnePolarity, p.track());
            looks[repeat] = (int) ((fit.votes() - before) / fit.size() / 2);
        }
        return motion;
    }

    /** Fits the velocity of such clouds, beside the motion that they are projected along. */
    private MetricFit fitted(Motion motion, Motion[] truth, double[] middles, double... reaches) {
        MetricFit fit = new MetricFit(128, 96, MetricFit.CELL_PX, 4096, 1900);
        Random random = new Random(5);
        for (int dot = 0; dot < 60; dot++) {
            Motion its = truth[dot % truth.length];
            double reach = reaches[dot % reaches.length];
            double x = middles[dot % truth.length] + 2 * reach * (random.nextDouble() - 0.5);
            double y = 40 + 2 * reach * (random.nextDouble() - 0.5);
            for (int k = 0; k < 20; k++) {
                long timeUs = Math.round((k + random.nextDouble() - 10) / 10 * HALF_S * 1e6);
                Place seen = PlainMotion.at(its, x, y, timeUs);
                Place at = PlainMotion.project(motion, Math.rint(seen.x()), Math.rint(seen.y()), timeUs);
                fit.add((float) at.x(), (float) at.y(), timeUs * 1e-6f, (float) (at.x() - 50),
                    (float) (at.y() - 40), 1);
            }
        }
        fit.frame(1 / HALF_S);
        loss.take(fit.fit(0, 0, MetricFit.FLAT_SIGMAS));
        return fit;
    }

    @Test
    public void accelerationAndRotationAreThoseOfTheEvents() {
        // 400 px/s² bend the ends of the window by 2 px, 0.5 rad/s turn them by 1 px at 20 px
        Motion truth = steady();
        truth.ax = 400;
        truth.omega = 0.5;
        Motion motion = measured(truth, DEFAULTS);
        assertEquals(400, motion.ax, 20);
        assertEquals(0, motion.ay, 20);
        assertEquals(0.5, motion.omega, 0.05);
        assertEquals(0, motion.growth, 0.05);
        assertTrue(loss.turn > 0);
    }

    @Test
    public void accelerationIsClearWhereItPassesTheNoiseOfTheMetric() {
        Motion truth = steady();
        measured(truth, DEFAULTS);
        assertTrue("steady: " + change.bendSigmas(), change.bendSigmas() < 0.9);
        truth.ax = 400;
        measured(truth, DEFAULTS);
        assertTrue("bent by 2 px: " + change.bendSigmas(), change.bendSigmas() > 5);
        change.restart();
        assertEquals(0, change.bendSigmas(), 0);
    }

    @Test
    public void growthIsThatOfTheEvents() {
        // 0.5 1/s shift the ends of the window by 1 px at 20 px
        Motion truth = steady();
        truth.growth = 0.5;
        Motion motion = measured(truth, DEFAULTS);
        assertEquals(0.5, motion.growth, 0.05);
        assertEquals(0, motion.omega, 0.05);
        assertTrue(loss.grow > 0);
        truth.growth = -0.5;
        assertEquals(-0.5, measured(truth, DEFAULTS).growth, 0.05);
    }

    @Test
    public void growthOfWhatGivesMostEventsOnOneSideIsFoundWithTheVelocityThatGoesWithIt() {
        Motion truth = steady();
        truth.growth = 0.5;
        // of the dots two thirds lie about 12 px to the right of the middle, where they move at 106 px/s
        Motion motion = steady();
        motion.vx = 106;
        for (int repeat = 0; repeat < 5; repeat++) {
            MetricFit fit = fitted(motion, new Motion[] {truth, truth, truth}, new double[] {62, 62, 50}, 8, 8, 20);
            change.measure(fit, motion, loss, HALF_S, RADIUS_PX, true, DEFAULTS.track());
        }
        assertEquals(0.5, motion.growth, 0.05);
        assertEquals("as the many dots", 106, motion.vx + 12 * motion.growth, 2);
    }

    @Test
    public void changeOfTheRotationIsThatOfTheEvents() {
        // 20 rad/s² turn the ends of the window by 2 px at 20 px; it needs a rotation to be seen beside
        Motion truth = steady();
        truth.omega = 0.5;
        truth.alpha = 20;
        Motion motion = measured(truth, DEFAULTS);
        assertEquals(0.5, motion.omega, 0.05);
        assertEquals(20, motion.alpha, 2);
    }

    @Test
    public void steadyMotionHasNoChange() {
        Motion motion = measured(steady(), DEFAULTS);
        assertEquals(0, motion.ax, 5);
        assertEquals(0, motion.ay, 5);
        assertEquals(0, motion.omega, 0.03);
        assertEquals(0, motion.growth, 0.03);
        // what does not turn is not measured to turn faster and faster
        assertEquals(0, motion.alpha, 0);
    }

    /** Measures two bodies, 15 px left and right of the middle, at 7.5 px/s outwards, as a growth of 0.5 has it. */
    private Motion measuredOfTwoThatComeApart() {
        Motion left = steady();
        left.vx -= 7.5;
        Motion right = steady();
        right.vx += 7.5;
        return measured(new Motion[] {left, right}, new double[] {35, 65}, 5, DEFAULTS);
    }

    @Test
    public void twoBodiesThatComeApartDoNotGrow() {
        Motion motion = measuredOfTwoThatComeApart();
        assertEquals(0, motion.growth, 0.1);
        assertEquals(0, motion.omega, 0.1);
    }

    /** Measures two bodies that pass each other as 0.5 rad/s would have it, 15 px from the middle. */
    private Motion measuredOfTwoThatPassEachOther() {
        Motion left = steady();
        left.vy -= 7.5;
        Motion right = steady();
        right.vy += 7.5;
        return measured(new Motion[] {left, right}, new double[] {35, 65}, 5, DEFAULTS);
    }

    @Test
    public void twoBodiesThatPassEachOtherDoNotTurn() {
        Motion motion = measuredOfTwoThatPassEachOther();
        assertEquals(0, motion.omega, 0.1);
        assertEquals(0, motion.growth, 0.1);
    }

    @Test
    public void whatIsKnownToBeOneBodyTurnsThoughNoPartOfItShowsThat() {
        change.believeTurning();
        assertEquals(0.5, measuredOfTwoThatPassEachOther().omega, 0.05);
        change.doubtBody();
        assertEquals(0, measuredOfTwoThatPassEachOther().omega, 0.1);
    }

    @Test
    public void whatIsOfOneBodyIsKnownWhetherItIsBelievedOrNot() {
        Motion motion = measuredOfTwoThatPassEachOther();
        assertEquals(0, motion.omega, 0.1);
        change.applyOfAll(motion);
        // from where it is not believed, the top is told by a parabola far beside it
        assertEquals(0.5, motion.omega, 0.25);
        change.restart();
        change.applyOfAll(motion);
        assertEquals(0, motion.omega, 0);
        assertEquals(0, motion.growth, 0);
    }

    @Test
    public void whatIsClearlyOneBodyGrowsToo() {
        change.believeTurning();
        assertEquals(0, measuredOfTwoThatComeApart().growth, 0.1);
        change.believeAll();
        assertEquals(0.5, measuredOfTwoThatComeApart().growth, 0.05);
        assertEquals(0.5, measuredOfTwoThatPassEachOther().omega, 0.05);
        change.doubtBody();
        assertEquals(0, measuredOfTwoThatComeApart().growth, 0.1);
    }

    @Test
    public void whatComesNearAtASteadySpeedGrowsAndAcceleratesByThat() {
        // of size s / (T - t), T = 4 s, the growth is 0.25 1/s, its change 0.0625 1/s²; at 100 px/s an acceleration of
        // 2 * 0.25 * 100 px/s²
        Motion truth = steady();
        truth.growth = 0.25;
        truth.growthChange = 0.0625;
        truth.ax = 50;
        change.believeAll();
        assertEquals("polarity tells that it comes near", 0, measured(truth, DEFAULTS).growthChange, 1e-9);
        isOfOnePolarity = true;
        Motion motion = measured(truth, DEFAULTS);
        assertEquals(0.25, motion.growth, 0.05);
        assertEquals(motion.growth * motion.growth, motion.growthChange, 1e-9);
        assertEquals(50, motion.ax, 10);
    }

    @Test
    public void changeOfTheGrowthIsThatFromWindowToWindowUntilTheMotionIsOfAnother() {
        // windows a twentieth of a second apart, in which a growth of 0.2 1/s becomes one of 0.45
        change.believeAll();
        Motion motion = steady();
        for (int window = 0; window < 6; window++) {
            measureGrowing(motion, 0.2 + 0.05 * window, 50_000L * window);
        }
        assertEquals(1, motion.growthChange, 0.2);
        change.take();
        double before = motion.growthChange;
        measureGrowing(motion, 0.47, 300_000);
        assertEquals("what led there is no slope", before, motion.growthChange, 0.1);
        change.take();
        measureGrowing(motion, 0.9, 350_000);
        assertEquals("of another structure nothing is known", 0, motion.growthChange, 0);
    }

    /** Measures a cloud, which grows so, in the window about a time, along the motion of the window before. */
    private void measureGrowing(Motion motion, double growth, long atUs) {
        Motion truth = steady();
        truth.growth = growth;
        motion.referenceUs = 0;
        MetricFit fit = fitted(motion, new Motion[] {truth}, new double[] {50}, RADIUS_PX);
        motion.referenceUs = atUs;
        change.measure(fit, motion, loss, HALF_S, RADIUS_PX, isOfOnePolarity, DEFAULTS.track());
    }

    @Test
    public void whatIsSwitchedOffIsNotMeasured() {
        Motion truth = steady();
        truth.ax = 400;
        truth.omega = 0.5;
        truth.alpha = 20;
        truth.growth = 0.5;
        Motion noGrowth = measured(truth, DEFAULTS.with("growth", false));
        assertEquals(0, noGrowth.growth, 0);
        assertEquals(0, loss.grow, 0);
        assertTrue(noGrowth.omega > 0.3);
        Motion noRotation = measured(truth, DEFAULTS.with("rotation", false));
        assertEquals(0, noRotation.omega, 0);
        assertEquals(0, noRotation.alpha, 0);
        assertEquals(0, loss.turn, 0);
        assertTrue(noRotation.growth > 0.3);
        Motion noAcceleration = measured(truth, DEFAULTS.with("acceleration", false));
        assertEquals(0, noAcceleration.ax, 0);
        assertEquals(0, noAcceleration.ay, 0);
        assertEquals(0, noAcceleration.alpha, 0);
        assertTrue(noAcceleration.omega > 0.3);
    }

    @Test
    public void bendIsTheShiftAtTheEndOfTheWindow() {
        // 400 px/s² in 0.1 s
        Motion truth = steady();
        truth.ax = 400;
        measured(truth, DEFAULTS);
        assertEquals(2, change.bendPx(HALF_S), 0.2);
        change.restart();
        assertEquals(0, change.bendPx(HALF_S), 0);
    }

    /** Measures a plane of 240 x 180 px whose middle is at (120, 90), from the velocity there, some times. */
    private Motion measuredPlane(Deformation deformation, double omega, int dots) {
        Motion truth = new Motion();
        truth.set(0, 100, 0);
        truth.omega = omega;
        truth.centreX = 120;
        truth.centreY = 90;
        truth.deformation.copyFrom(deformation);
        Motion motion = new Motion();
        motion.set(0, 100, 0);
        motion.centreX = 120;
        motion.centreY = 90;
        change.restart();
        loss.clear();
        MetricFit fit = new MetricFit(240, 180, MetricFit.CELL_PX, 1 << 14, 1900);
        SteppedProjection projection = new SteppedProjection();
        for (int repeat = 0; repeat < 24; repeat++) {
            Random random = new Random(5);
            fit.clear();
            projection.begin(motion, 50_000, 200, 1.0 / 32);
            for (int dot = 0; dot < dots; dot++) {
                double x = 240 * random.nextDouble();
                double y = 180 * random.nextDouble();
                for (int k = 0; k < 12; k++) {
                    long timeUs = Math.round((k + random.nextDouble() - 6) / 6 * 50_000);
                    // straight on: what a point is deformed by in the time is less than a px
                    int seenX = (int) Math.rint(x + truth.vxAt((int) x, (int) y, 0) * timeUs * 1e-6);
                    int seenY = (int) Math.rint(y + truth.vyAt((int) x, (int) y, 0) * timeUs * 1e-6);
                    projection.goTo(timeUs);
                    fit.add(motion, projection.x(seenX, seenY), projection.y(seenX, seenY), timeUs * 1e-6, 1);
                }
            }
            fit.frame(1 / 0.05);
            VelocityTop top = fit.fit(0, 0, MetricFit.FLAT_SIGMAS);
            loss.take(top);
            motion.vx += top.stepX();
            motion.vy += top.stepY();
            change.measure(fit, motion, loss, 0.05, 75, false, DEFAULTS.track());
        }
        return motion;
    }

    @Test
    public void planeSeenAtASlantIsDeformedAsItsEventsSay() {
        // below its middle it moves the more to the right, by 0.16 1/s: half of it rotation
        Deformation slant = new Deformation();
        slant.stretch = 0.06;
        slant.shear = 0.08;
        Motion motion = measuredPlane(slant, -0.08, 700);
        assertEquals(0.06, motion.deformation.stretch, 0.006);
        assertEquals(0.08, motion.deformation.shear, 0.008);
        assertEquals(-0.08, motion.omega, 0.008);
        assertEquals(100, motion.vx, 1);
    }

    @Test
    public void planeBeforeACameraThatTurnsHasPerspective() {
        // a focal length of 200 px: 100 px/s in the middle, 136 at the borders
        Deformation perspective = new Deformation();
        perspective.perspectiveX = 100 / 40_000.0;
        Motion motion = measuredPlane(perspective, 0, 700);
        assertEquals(0.0025, motion.deformation.perspectiveX, 0.00025);
        assertEquals(0, motion.deformation.perspectiveY, 0.00025);
        assertEquals(0, motion.deformation.stretch, 0.01);
        assertEquals(100, motion.vx, 1);
    }

    @Test
    public void planeThatIsNotDeformedStaysSo() {
        Motion motion = measuredPlane(new Deformation(), 0, 700);
        assertEquals(0, motion.deformation.stretch, 0.002);
        assertEquals(0, motion.deformation.shear, 0.002);
        assertEquals(0, motion.deformation.perspectiveX, 2e-5);
    }

    @Test
    public void fewEventsShowNoDeformation() {
        Deformation slant = new Deformation();
        slant.stretch = 0.06;
        assertTrue(measuredPlane(slant, 0, 160).deformation.isNone());
    }

    @Test
    public void heldChangeFadesByAFifth() {
        Motion motion = new Motion();
        motion.ax = 100;
        motion.ay = -50;
        motion.omega = -2;
        motion.alpha = 10;
        motion.growth = 0.5;
        motion.growthChange = 0.3;
        motion.deformation.stretch = 0.1;
        change.hold(motion);
        assertEquals(80, motion.ax, 1e-9);
        assertEquals(-40, motion.ay, 1e-9);
        assertEquals(-1.6, motion.omega, 1e-9);
        assertEquals(8, motion.alpha, 1e-9);
        assertEquals(0.4, motion.growth, 1e-9);
        assertEquals(0.24, motion.growthChange, 1e-9);
        assertEquals(0.08, motion.deformation.stretch, 1e-9);
    }

    @Test
    public void smallChangeOfWhatWasJustFoundIsBelievedLess() {
        // 30 px/s² bend the ends of the window by 0.15 px; of 1,200 events 0.079 px may be noise and from the 40th time
        // 0.055, so that 0.78 and 0.88 of it count, and of less than that, as is measured, parts that differ more
        Motion truth = steady();
        truth.ax = 30;
        repeats = 39;
        double settling = measured(truth, DEFAULTS).ax;
        repeats = 40;
        double settled = measured(truth, DEFAULTS).ax;
        assertTrue(settling + " and " + settled, settled > 0.88 / 0.78 * settling && settled < 30);
    }

    @Test
    public void turningBeyondDoubtIsAskedWithinTilesEveryFourthTime() {
        Motion truth = steady();
        truth.omega = 0.5;
        measured(truth, DEFAULTS);
        // two each for both accelerations, rotation, growth and the rotation's change, and two within tiles
        assertEquals(List.of(12, 12), List.of(looks[0], looks[1]));
        assertEquals(List.of(10, 10, 10, 12), List.of(looks[4], looks[5], looks[6], looks[7]));
    }
}
