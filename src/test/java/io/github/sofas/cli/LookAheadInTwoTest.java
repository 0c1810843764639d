package io.github.sofas.cli;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.flow.LabelledSource;
import io.github.sofas.flow.Labelling;
import io.github.sofas.flow.SmoothedSofas;
import io.github.sofas.flow.SofasParameters;
import io.github.sofas.simulate.Scene;
import io.github.sofas.simulate.SimulatedRecording;
import io.github.sofas.simulate.SimulationOptions;
import java.util.ArrayList;
import java.util.List;
import org.junit.Test;

public class LookAheadInTwoTest {
    private static final SimulatedRecording FILM = SimulatedRecording.of(Scene.THREE_CROSSING,
        SimulationOptions.defaults().withDurationUs(600_000));

    private static SmoothedSofas sofas(SensorSize sensor) {
        return new SmoothedSofas(sensor, SofasParameters.defaults(), 100_000);
    }

    private static List<String> labels(Labelling labelling) throws Exception {
        List<String> labels = new ArrayList<>();
        LabelledSource source = new LabelledSource(FILM.source(), labelling);
        EventBatch batch = new EventBatch(1000);
        FlowOutput flow = new FlowOutput(1000);
        while (source.next(batch, flow)) {
            for (int i = 0; i < batch.size(); i++) {
                labels.add(batch.timeUs[i] + " " + flow.segment[i] + " " + flow.vxPxPerS[i] + " " + flow.vyPxPerS[i]);
            }
        }
        return labels;
    }

    @Test
    public void labelsAndSegmentsAreThoseOfOneThread() throws Exception {
        SmoothedSofas one = sofas(FILM.sensor());
        List<String> expected = labels(one);
        try (LookAheadInTwo two = new LookAheadInTwo(sofas(FILM.sensor()))) {
            assertEquals(expected, labels(two));
            assertEquals(one.segments(), two.segments());
        }
        assertEquals(FILM.size(), expected.size());
    }

    @Test
    public void segmentsAreThoseOfAllBatchesThatWereAdded() throws Exception {
        try (LookAheadInTwo two = new LookAheadInTwo(sofas(FILM.sensor()))) {
            EventBatch batch = new EventBatch(4096);
            assertTrue(FILM.source().next(batch));
            two.add(batch);
            assertEquals(sofasAfter(batch), two.segments());
        }
    }

    private static Object sofasAfter(EventBatch batch) {
        SmoothedSofas one = sofas(FILM.sensor());
        one.add(batch);
        return one.segments();
    }
}
