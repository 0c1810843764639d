package io.github.sofas.flow;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.PlainPlane.Event;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Random;
import org.junit.Test;

/**
 * Boxes of 32 x 20 px that turn all the time. They go to the right by 60 px/s for a second, slow down by 200 px/s²
 * within 0.3 s, and stand from then on at (109, 40), where they turn until 2.2 s.
 */
public class StopsAndTurnsOnTest {
    private static final SensorSize SENSOR = new SensorSize(160, 80);
    private static final double HALF_WIDTH_PX = 16;
    private static final double HALF_HEIGHT_PX = 10;
    private static final double PX_PER_S = 60;
    private static final double PX_PER_S2 = 200;
    private static final double SLOWS_S = 1;
    private static final double STANDS_S = 1.3;
    private static final double STANDS_X = 40 + PX_PER_S + PX_PER_S * 0.3 / 2;
    private static final double Y = 40;
    private static final double UNTIL_S = 2.2;
    private static final double STEP_S = 5e-4;

    private static double x(double timeS) {
        double slowedS = Math.max(0, Math.min(timeS, STANDS_S) - SLOWS_S);
        return 40 + PX_PER_S * Math.min(timeS, STANDS_S) - PX_PER_S2 / 2 * slowedS * slowedS;
    }

    private static boolean isCovered(double x, double y, double radPerS, double timeS) {
        double cos = Math.cos(radPerS * timeS);
        double sin = Math.sin(radPerS * timeS);
        double rx = x - x(timeS);
        double ry = y - Y;
        return Math.abs(cos * rx + sin * ry) < HALF_WIDTH_PX && Math.abs(cos * ry - sin * rx) < HALF_HEIGHT_PX;
    }

    /** Each pixel that the outline passes fires once, as if it lay a tenth of a px to one side. */
    private static List<Event> events(double radPerS) {
        Random random = new Random(1);
        List<Event> events = new ArrayList<>();
        for (int pixel = 0; pixel < SENSOR.width() * SENSOR.height(); pixel++) {
            double x = pixel % SENSOR.width() + 0.1 * random.nextGaussian();
            double y = pixel / SENSOR.width() + 0.1 * random.nextGaussian();
            if (Math.abs(y - Y) > 20) {
                continue;
            }
            boolean covered = isCovered(x, y, radPerS, 0);
            for (int k = 1; k * STEP_S < UNTIL_S; k++) {
                boolean before = covered;
                covered = isCovered(x, y, radPerS, k * STEP_S);
                if (covered != before) {
                    events.add(new Event(pixel % SENSOR.width(), pixel / SENSOR.width(),
                        (long) (k * STEP_S * 1e6) + random.nextInt(500), covered ? -1 : 1));
                }
            }
        }
        events.sort(Comparator.comparingLong(Event::timeUs));
        return events;
    }

    @Test
    public void whatStopsAndTurnsOnIsFollowedByItsSegmentWithItsRotation() {
        for (double radPerS : new double[] {0.7, 1, -0.7, -1}) {
            Sofas sofas = new Sofas(SENSOR, SofasParameters.defaults());
            EventBatch batch = new EventBatch(1);
            FlowOutput flow = new FlowOutput(1);
            int id = 0;
            int events = 0;
            int followed = 0;
            double off = 0;
            double speeds = 0;
            for (Event e : events(radPerS)) {
                batch.clear();
                batch.add(e.timeUs(), e.x(), e.y(), e.polarity());
                sofas.process(batch, flow);
                if (e.timeUs() < SLOWS_S * 1e6) {
                    id = flow.segment[0];
                } else if (e.timeUs() > 1.5e6) {
                    events++;
                    followed += flow.segment[0] == id ? 1 : 0;
                    double vx = -radPerS * (e.y() - Y);
                    double vy = radPerS * (e.x() - STANDS_X);
                    off += Math.hypot(flow.vxPxPerS[0] - vx, flow.vyPxPerS[0] - vy);
                    speeds += Math.hypot(vx, vy);
                }
            }
            String turns = radPerS + " rad/s";
            assertTrue(turns + ", followed before", id > 0);
            assertEquals(turns + ", events of its segment", 1, (double) followed / events, 0.05);
            assertEquals(turns + ", share of the speed off", 0, off / speeds, 0.2);
        }
    }
}
