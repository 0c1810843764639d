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

/** A disc of 32 px that goes right at 60 px/s for a second, and from then on is pulled back by 200 px/s². */
public class TurningBackTest {
    private static final SensorSize SENSOR = new SensorSize(200, 64);
    private static final double RADIUS_PX = 16;
    private static final double PX_PER_S = 60;
    private static final double PX_PER_S2 = 200;
    /** It stands at 1.3 s, and is as fast as before at 1.6 s. */
    private static final double UNTIL_S = 1.6;
    private static final double STEP_S = 1e-4;

    private static double centreX(double timeS) {
        double pulledS = Math.max(0, timeS - 1);
        return 40 + PX_PER_S * timeS - PX_PER_S2 / 2 * pulledS * pulledS;
    }

    private static double vx(double timeS) {
        return PX_PER_S - PX_PER_S2 * Math.max(0, timeS - 1);
    }

    /** Each pixel that its outline passes fires once, a tenth of a px early or late. */
    private static List<Event> film() {
        List<Event> events = new ArrayList<>();
        Random random = new Random(1);
        for (int pixel = 0; pixel < SENSOR.width() * SENSOR.height(); pixel++) {
            double x = pixel % SENSOR.width() + 0.1 * random.nextGaussian();
            double y = pixel / SENSOR.width() - SENSOR.height() / 2.0;
            boolean covered = isCovered(x, y, 0);
            for (int k = 1; k * STEP_S < UNTIL_S; k++) {
                boolean before = covered;
                covered = isCovered(x, y, k * STEP_S);
                if (covered != before) {
                    events.add(new Event(pixel % SENSOR.width(), pixel / SENSOR.width(),
                        (long) (k * STEP_S * 1e6) + random.nextInt((int) (STEP_S * 1e6)), covered ? -1 : 1));
                }
            }
        }
        events.sort(Comparator.comparingLong(Event::timeUs));
        return events;
    }

    private static boolean isCovered(double x, double y, double timeS) {
        return Math.hypot(x - centreX(timeS), y) < RADIUS_PX;
    }

    @Test
    public void whatTurnsBackIsFollowedByItsSegmentWithItsVelocity() {
        Sofas sofas = new Sofas(SENSOR, SofasParameters.defaults());
        EventBatch batch = new EventBatch(1);
        FlowOutput flow = new FlowOutput(1);
        int events = 0;
        int labelled = 0;
        double off = 0;
        int id = 0;
        for (Event e : film()) {
            batch.clear();
            batch.add(e.timeUs(), e.x(), e.y(), e.polarity());
            sofas.process(batch, flow);
            double timeS = e.timeUs() * 1e-6;
            if (timeS < 1) {
                id = flow.segment[0];
            } else if (timeS > 1.2) {
                events++;
                labelled += flow.segment[0] == id ? 1 : 0;
                off += Math.hypot(flow.vxPxPerS[0] - vx(timeS), flow.vyPxPerS[0]);
            }
        }
        assertTrue("followed before", id > 0);
        assertEquals("events of its segment", 1, (double) labelled / events, 0.1);
        assertTrue(off / events + " px/s off", off / events < 10);
    }
}
