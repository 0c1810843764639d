package io.github.sofas.experiments;

import io.github.sofas.evaluate.KnownTranslations;
import io.github.sofas.evaluate.Sharpness;
import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.flow.LabelledSource;
import io.github.sofas.flow.Labelling;
import io.github.sofas.recording.RecordingOptions;
import io.github.sofas.recording.RecordingReader;
import io.github.sofas.recording.Recordings;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;

/**
 * The figures of a method on a recording of a real camera, which has no truth.
 *
 * @param name file name of the recording
 * @param sharpness how sharp the flow makes the picture of the recording
 * @param segments number of segments that hold at least a hundredth of the events with flow
 * @param nsPerEvent processor time of the method per event, in ns
 */
record RecordingFigures(String name, Sharpness sharpness, long segments, double nsPerEvent) {
    private static final int BATCH = 4096;
    private static final double LEAST_SHARE = 0.01;

    /**
     * Reads, labels and measures a recording.
     *
     * @param chip the sensor's name; null if the recording names it
     * @throws EventSourceException if the recording cannot be read to its end
     */
    static RecordingFigures of(Path file, String chip, Function<SensorSize, Labelling> maker,
                               KnownTranslations known) throws EventSourceException {
        String name = file.getFileName().toString();
        try (RecordingReader reader = Recordings.open(file, RecordingOptions.defaults().withChip(chip))) {
            CpuTime method = new CpuTime(maker.apply(reader.sensor()));
            Sharpness.Gatherer gatherer = new Sharpness.Gatherer(reader.sensor(), known, name);
            EventBatch batch = new EventBatch(BATCH);
            FlowOutput output = new FlowOutput(BATCH);
            Map<Integer, Long> eventsBySegment = new HashMap<>();
            LabelledSource labelled = new LabelledSource(reader, method);
            while (labelled.next(batch, output)) {
                gatherer.add(batch, output);
                for (int i = 0; i < batch.size(); i++) {
                    if (output.segment[i] != 0) {
                        eventsBySegment.merge(output.segment[i], 1L, Long::sum);
                    }
                }
            }
            Sharpness sharpness = gatherer.sharpness();
            long segments = eventsBySegment.values().stream()
                .filter(events -> events >= LEAST_SHARE * sharpness.eventsWithFlow()).count();
            return new RecordingFigures(name, sharpness, segments, method.nsPerEvent());
        }
    }

    /** Median gain over the recordings that have one; 0 if none has. */
    static double medianGain(List<RecordingFigures> recordings) {
        double[] gains = gains(recordings);
        return gains.length == 0 ? 0 : (gains[(gains.length - 1) / 2] + gains[gains.length / 2]) / 2;
    }

    /** Smallest gain of the recordings that have one; 0 if none has. */
    static double worstGain(List<RecordingFigures> recordings) {
        double[] gains = gains(recordings);
        return gains.length == 0 ? 0 : gains[0];
    }

    /** Number of recordings whose picture the flow makes less sharp. */
    static long blurred(List<RecordingFigures> recordings) {
        return recordings.stream().filter(each -> each.sharpness.sharpness() < 1).count();
    }

    private static double[] gains(List<RecordingFigures> recordings) {
        return recordings.stream().filter(each -> each.sharpness.hasGain())
            .mapToDouble(each -> each.sharpness.gain()).sorted().toArray();
    }
}
