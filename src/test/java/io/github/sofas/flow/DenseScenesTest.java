package io.github.sofas.flow;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import io.github.sofas.simulate.Scene;
import io.github.sofas.simulate.SimulatedSource;
import io.github.sofas.simulate.SimulationOptions;
import io.github.sofas.simulate.Truth;
import java.util.HashMap;
import java.util.Map;
import org.junit.Test;

/** A textured wall before a sensor of 1280 x 720 px at 50 million events a second: found at once, as one segment. */
public class DenseScenesTest {
    private static final double PX_PER_S = 350;
    private static final long DURATION_US = 32_000;
    /** After 6.3 px of travel, the longest that the flow plane holds an event for. */
    private static final long FOUND_US = 18_000;

    @Test
    public void wallIsFoundAsOneSegmentInTheTimeOfSixPixels() {
        SimulationOptions options = SimulationOptions.defaults().withSensor(new SensorSize(1280, 720))
            .withSpeedPxPerS(PX_PER_S).withDurationUs(DURATION_US);
        Sofas sofas = new Sofas(options.sensor(), SofasParameters.defaults());
        EventBatch batch = new EventBatch(4096);
        FlowOutput flow = new FlowOutput(4096);
        Truth truth = new Truth(4096);
        Map<Integer, Integer> segments = new HashMap<>();
        int events = 0;
        int withFlow = 0;
        double error = 0;
        try (SimulatedSource source = new SimulatedSource(Scene.TEXTURED_PAN, options)) {
            while (source.next(batch, truth)) {
                sofas.process(batch, flow);
                for (int i = 0; i < batch.size(); i++) {
                    if (batch.timeUs[i] > FOUND_US && truth.object[i] == 1) {
                        events++;
                        if (flow.segment[i] != 0) {
                            withFlow++;
                            segments.merge(flow.segment[i], 1, Integer::sum);
                            error += Math.hypot(flow.vxPxPerS[i] - truth.vxPxPerS[i],
                                flow.vyPxPerS[i] - truth.vyPxPerS[i]) / PX_PER_S;
                        }
                    }
                }
            }
        }
        assertTrue("events " + events, events > 500_000);
        assertTrue("with flow " + withFlow + " of " + events, withFlow > 0.96 * events);
        assertTrue("relative error " + error / withFlow, error / withFlow < 0.04);
        int large = events / 100;
        assertEquals(1, segments.values().stream().filter(count -> count >= large).count());
    }
}
