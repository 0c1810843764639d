package io.github.sofas.flow.smooth;

import static io.github.sofas.flow.smooth.SegmentPathTest.motion;
import static org.junit.Assert.assertEquals;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.motion.Motion;
import org.junit.Test;

public class PathMeanTest {
    private static final double EXACT = 1e-9;

    private final SegmentPath path = new SegmentPath(1);

    @Test
    public void motionAboutATimeIsThatOfTheMiddleOfItsBlock() {
        path.add(motion(0, 100, 0));
        path.add(motion(1_000_000, 200, 0));
        // from 200 to 300 ms
        assertEquals(125, path.about(299_999, 100_000).vx, EXACT);
        assertEquals(125, path.about(200_000, 100_000).vx, EXACT);
        path.add(motion(500_000, 100, 0));
        assertEquals("a new measurement counts at once", 100, path.about(200_000, 100_000).vx, EXACT);
    }

    @Test
    public void measurementsThatSwingAboutAMotionAreAveraged() {
        // 90 and 110 px/s in turn, each 5 ms; 6 px of travel are 60 ms
        for (int k = 0; k <= 40; k++) {
            Motion knot = motion(5_000L * k, k % 2 == 0 ? 90 : 110, 0.5 * k);
            knot.omega = k % 2 == 0 ? 1 : 3;
            knot.growth = k % 2 == 0 ? -1 : 1;
            path.add(knot);
        }
        for (long us = 60_000; us < 140_000; us += 1_000) {
            Motion about = path.about(us, 1_000);
            assertEquals(100, about.vx, 3);
            assertEquals(2, about.omega, 0.3);
            assertEquals(0, about.growth, 0.3);
        }
    }

    @Test
    public void averageOfAMotionThatChangesEvenlyIsThatMotion() {
        path.add(motion(0, 100, 0));
        path.add(motion(1_000_000, 200, 150));
        for (long us = 500; us < 1_000_000; us += 9_000) {
            assertEquals(100 + us / 1000 * 0.1 + 0.05, path.about(us, 1_000).vx, 0.01);
        }
    }

    @Test
    public void averageIsOverLessTravelWhereManyEventsShowTheMotion() {
        // 100 to 200 px/s in 0.5 s, and back: the mean about the peak is less by 200 px/s² times 0.328 of either side
        path.add(motion(0, 100, 0));
        path.add(motion(500_000, 200, 75));
        path.add(motion(1_000_000, 100, 150));
        assertEquals("6 px, 30 ms", 198.03, path.about(500_000, 2).vx, 0.01);
        assertEquals("2,000 events in 40 ms; their bend adds a little", 198.045, aboutPeak(25_000), 0.01);
        assertEquals("in 10 ms, 2 px", 199.34, aboutPeak(100_000), 0.01);
        assertEquals("in 2 ms, but 1 px at least, 5 ms", 199.67, aboutPeak(500_000), 0.01);
    }

    @Test
    public void bendIsBelievedAsFarAsTheEventsShowIt() {
        // 300 px/s less 100 px/s times the square of the time in sides of 6 px, 20 ms: the mean of 15 samples is less
        // by 100 px/s times 10.5 / 64, which shifts the events by 0.328 px in 20 ms
        for (int k = -100; k <= 100; k++) {
            path.add(motion(500_000 + 1_000L * k, 300 - 100 * (k / 20.0) * (k / 20.0), 0));
        }
        assertEquals("few events", 283.6, aboutPeak(100), 0.1);
        // 12 px by the root of 1,337 events is as much: a half
        assertEquals(291.8, aboutPeak(1_337 * 25), 0.1);
    }

    @Test
    public void deformationIsAveraged() {
        Motion first = motion(0, 100, 0);
        first.deformation.stretch = 0.1;
        Motion second = motion(1_000_000, 100, 100);
        second.deformation.stretch = 0.3;
        path.add(first);
        path.add(second);
        // over as much before as after, the mean is that of the middle
        assertEquals(0.2, path.about(500_000, 2).deformation.stretch, 1e-4);
    }

    /** Mean speed about the peak, with so many events in the half second around it. */
    private double aboutPeak(int events) {
        EventWindow window = new EventWindow();
        for (int k = 0; k < events; k++) {
            window.give(window.add(250_000 + 500_000L * k / events, 0, 20 + k % 40, 10, 1), 1, 1);
        }
        path.refine(new Slice(window, new SensorSize(96, 64), 0, 250_000, 750_000, 0), 1_000_000,
            (us, sideUs, least) -> null);
        path.about(0, 2);
        return path.about(500_000, 2).vx;
    }

    @Test
    public void nothingIsAveragedBeforeTheFirstAndAfterTheLastMeasurement() {
        path.add(motion(100_000, 100, 0));
        path.add(motion(200_000, 200, 15));
        assertEquals(100, path.about(50_000, 1_000).vx, EXACT);
        assertEquals(200, path.about(250_000, 1_000).vx, EXACT);
    }
}
