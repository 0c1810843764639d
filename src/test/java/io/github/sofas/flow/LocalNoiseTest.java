package io.github.sofas.flow;

import static org.junit.Assert.assertTrue;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import java.util.Random;
import org.junit.Test;

/** A part of the sensor where a light trembles: 300 noise events a second and pixel, and none around it. */
public class LocalNoiseTest {
    private static final int SIDE = 20;
    private static final double MEAN_GAP_US = 8.3;
    private static final int EVENTS = 200_000;
    private static final int FILMS = 4;

    private static int eventsWithFlow(long seed) {
        Random random = new Random(seed);
        Sofas sofas = new Sofas(new SensorSize(346, 260), SofasParameters.defaults());
        EventBatch batch = new EventBatch(1000);
        FlowOutput flow = new FlowOutput(1000);
        double timeUs = 0;
        int withFlow = 0;
        for (int begin = 0; begin < EVENTS; begin += 1000) {
            batch.clear();
            for (int i = 0; i < 1000; i++) {
                timeUs -= MEAN_GAP_US * Math.log(1 - random.nextDouble());
                batch.add((long) timeUs, 173 + random.nextInt(SIDE), 130 + random.nextInt(SIDE),
                    random.nextBoolean() ? 1 : -1);
            }
            sofas.process(batch, flow);
            for (int i = 0; i < 1000; i++) {
                withFlow += flow.segment[i] != 0 ? 1 : 0;
            }
        }
        return withFlow;
    }

    @Test
    public void noiseOfAPartOfTheSensorMovesNowhere() {
        int withFlow = 0;
        for (int seed = 1; seed <= FILMS; seed++) {
            withFlow += eventsWithFlow(seed);
        }
        // without a look at whether they meet, 27 of 100
        assertTrue(withFlow + " with flow", withFlow < 0.05 * FILMS * EVENTS);
    }
}
