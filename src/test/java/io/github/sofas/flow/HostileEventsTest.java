package io.github.sofas.flow;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.Test;

/** Whatever events come, the engine stays sound: what it says is finite, on the sensor, and the same each time. */
public class HostileEventsTest {
    private static final SensorSize SENSOR = new SensorSize(64, 48);
    private static final int EVENTS = 24_000;
    private static final List<SofasParameters> PRESETS = List.of(SofasParameters.defaults(), SofasParameters.paper());

    /** Runs a stream in batches, checks all that is said of it, and returns a checksum of it. */
    private static long run(String name, SofasParameters p, SensorSize sensor, EventBatch stream, int batchSize) {
        List<Segment> ended = new ArrayList<>();
        Sofas sofas = new Sofas(sensor, p, ended::add);
        EventBatch batch = new EventBatch(batchSize);
        FlowOutput output = new FlowOutput(batchSize);
        long sum = 0;
        for (int from = 0; from < stream.size(); from += batchSize) {
            int size = Math.min(batchSize, stream.size() - from);
            batch.clear();
            batch.addAll(stream, from, size);
            sofas.process(batch, output);
            for (int i = 0; i < size; i++) {
                boolean finite = Float.isFinite(output.vxPxPerS[i]) && Float.isFinite(output.vyPxPerS[i]);
                assertTrue(name + ": velocity of event " + (from + i), finite);
                assertTrue(name, output.segment[i] >= 0);
                sum = 31 * sum + output.segment[i];
                sum = 31 * sum + Float.floatToIntBits(output.vxPxPerS[i]);
                sum = 31 * sum + Float.floatToIntBits(output.vyPxPerS[i]);
            }
            assertTrue(name, sofas.segments().size() <= p.track().maxTrackPlanes());
            sofas.segments().forEach(segment -> check(name, segment, sensor));
        }
        ended.forEach(segment -> check(name, segment, sensor));
        return 31 * sum + ended.hashCode();
    }

    static void check(String name, Segment s, SensorSize sensor) {
        assertTrue(name + ": " + s, Float.isFinite(s.vxPxPerS()) && Float.isFinite(s.vyPxPerS()));
        assertTrue(name + ": " + s, s.minX() >= 0 && s.minX() <= s.maxX() && s.maxX() < sensor.width());
        assertTrue(name + ": " + s, s.minY() >= 0 && s.minY() <= s.maxY() && s.maxY() < sensor.height());
        assertTrue(name + ": " + s, s.firstTimeUs() <= s.lastTimeUs() && s.events() >= 0);
    }

    @Test
    public void tenThousandStructuresLeaveTheEngineSound() {
        SensorSize sensor = new SensorSize(400, 400);
        EventBatch stream = HostileStreams.structures(sensor, 60_000);
        for (SofasParameters p : PRESETS) {
            String name = p.preset() + ", 10,000 structures";
            assertEquals(name, run(name, p, sensor, stream, 4096), run(name, p, sensor, stream, 3000));
        }
    }

    @Test
    public void everyVelocityIsFiniteAndEveryStructureOnTheSensor() {
        for (SofasParameters p : PRESETS) {
            for (Map.Entry<String, EventBatch> stream : HostileStreams.all(SENSOR, EVENTS).entrySet()) {
                String name = p.preset() + ", " + stream.getKey();
                long first = run(name, p, SENSOR, stream.getValue(), 4096);
                assertEquals(name + ": the same again", first, run(name, p, SENSOR, stream.getValue(), 1000));
            }
        }
    }
}
