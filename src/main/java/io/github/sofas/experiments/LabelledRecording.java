package io.github.sofas.experiments;

import io.github.sofas.evaluate.FlowEstimate;
import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.flow.EventLabeller;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.recording.ImuSample;
import io.github.sofas.recording.RecordingOptions;
import io.github.sofas.recording.RecordingReader;
import io.github.sofas.recording.Recordings;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.function.IntPredicate;

/**
 * A recording of a real camera in memory, labelled by every method. Gives median velocities over spans of time. Times
 * are in s from the first event.
 */
final class LabelledRecording {
    private static final int BATCH = 4096;

    private final Map<ComparedMethod, FlowEstimate> estimates = new EnumMap<>(ComparedMethod.class);
    private final List<ImuSample> imuSamples = new ArrayList<>();
    private double[] timeS = new double[BATCH];
    private short[] x = new short[BATCH];
    private short[] y = new short[BATCH];
    private int size;
    private long firstUs;

    private LabelledRecording() {
    }

    /**
     * Reads a recording once, and passes every batch to every method.
     *
     * @param chip the sensor's name; null if the recording names it
     */
    static LabelledRecording of(Path file, String chip) throws EventSourceException {
        LabelledRecording recording = new LabelledRecording();
        try (RecordingReader reader = Recordings.open(file, RecordingOptions.defaults().withChip(chip))) {
            reader.onImuSample(recording.imuSamples::add);
            Map<ComparedMethod, EventLabeller> methods = new EnumMap<>(ComparedMethod.class);
            for (ComparedMethod method : ComparedMethod.values()) {
                methods.put(method, method.make(reader.sensor()));
                recording.estimates.put(method, new FlowEstimate());
            }
            EventBatch batch = new EventBatch(BATCH);
            FlowOutput output = new FlowOutput(BATCH);
            while (reader.next(batch)) {
                methods.forEach((method, labeller) -> {
                    labeller.process(batch, output);
                    recording.estimates.get(method).append(output, batch.size());
                });
                recording.append(batch);
            }
        }
        return recording;
    }

    private void append(EventBatch batch) {
        int n = batch.size();
        if (size == 0) {
            firstUs = batch.timeUs[0];
        }
        if (size + n > timeS.length) {
            int capacity = Math.max(size + n, 2 * timeS.length);
            timeS = Arrays.copyOf(timeS, capacity);
            x = Arrays.copyOf(x, capacity);
            y = Arrays.copyOf(y, capacity);
        }
        for (int i = 0; i < n; i++) {
            timeS[size + i] = (batch.timeUs[i] - firstUs) * 1e-6;
        }
        System.arraycopy(batch.x, 0, x, size, n);
        System.arraycopy(batch.y, 0, y, size, n);
        size += n;
    }

    int size() {
        return size;
    }

    double durationS() {
        return size == 0 ? 0 : timeS[size - 1];
    }

    double timeS(int i) {
        return timeS[i];
    }

    int x(int i) {
        return x[i];
    }

    int y(int i) {
        return y[i];
    }

    FlowEstimate by(ComparedMethod method) {
        return estimates.get(method);
    }

    /** The samples of the camera's inertial measurement unit (IMU). */
    List<ImuSample> imuSamples() {
        return imuSamples;
    }

    /** Time of an IMU sample in s. */
    double timeS(ImuSample sample) {
        return (sample.timeUs() - firstUs) * 1e-6;
    }

    /** Share of all events to which a method gives flow. */
    double shareWithFlow(ComparedMethod method) {
        FlowEstimate estimate = by(method);
        int withFlow = 0;
        for (int i = 0; i < size; i++) {
            withFlow += estimate.hasFlow(i) ? 1 : 0;
        }
        return size == 0 ? 0 : (double) withFlow / size;
    }

    /** Index of the first event at or after a time. */
    int firstAt(double seconds) {
        int at = Arrays.binarySearch(timeS, 0, size, seconds);
        if (at < 0) {
            return -at - 1;
        }
        while (at > 0 && timeS[at - 1] == seconds) {
            at--;
        }
        return at;
    }

    /** Median velocity to the right, in px/s, of the events with flow in a span of time that a condition picks. */
    double medianVx(ComparedMethod method, double fromS, double untilS, IntPredicate picks) {
        return median(method, fromS, untilS, picks, true);
    }

    /** Median velocity downwards of the same events, in px/s. */
    double medianVy(ComparedMethod method, double fromS, double untilS, IntPredicate picks) {
        return median(method, fromS, untilS, picks, false);
    }

    private double median(ComparedMethod method, double fromS, double untilS, IntPredicate picks, boolean right) {
        FlowEstimate estimate = by(method);
        Medians medians = new Medians();
        for (int i = firstAt(fromS); i < size && timeS[i] < untilS; i++) {
            if (estimate.hasFlow(i) && picks.test(i)) {
                medians.add(right ? estimate.vxPxPerS(i) : estimate.vyPxPerS(i));
            }
        }
        return medians.median();
    }

    /** Median velocity to the right over time, in bins, of the events that a condition picks. */
    Curve medianVxCurve(ComparedMethod method, double binS, IntPredicate picks) {
        int bins = (int) Math.ceil(durationS() / binS);
        double[] middles = new double[bins];
        double[] medians = new double[bins];
        for (int b = 0; b < bins; b++) {
            middles[b] = (b + 0.5) * binS;
            medians[b] = medianVx(method, b * binS, (b + 1) * binS, picks);
        }
        return new Curve(middles, medians);
    }
}
