package io.github.sofas.evaluate;

import io.github.sofas.flow.EventLabeller;
import io.github.sofas.simulate.SimulatedRecording;
import java.util.ArrayList;
import java.util.List;

/**
 * All figures of one estimate against its truth. An event counts in the flow, noise and segmentation figures if its
 * time is at least first + skipFirstShare (last - first). Convergence and first labels are taken over the whole
 * recording.
 *
 * @param options options that determine which events count
 * @param events number of events of the recording
 * @param eventsCounted number of events after the share of time that is left out
 * @param noiseEvents number of noise events that count
 * @param noiseEventsWithFlow number of those noise events that have flow
 * @param flow flow figures over all objects
 * @param flowByObject flow figures of each object, by rising id
 * @param segmentation segmentation figures over all objects
 * @param segmentationByObject segmentation figures of each object, by rising id
 * @param convergence error over the time since appearance
 */
public record Evaluation(EvaluationOptions options, long events, long eventsCounted, long noiseEvents,
                         long noiseEventsWithFlow, FlowFigures flow, List<FlowFigures> flowByObject,
                         SegmentationFigures segmentation, List<SegmentationFigures> segmentationByObject,
                         List<ConvergenceBin> convergence) {
    /**
     * Computes all figures.
     *
     * @param truth truth of every event
     * @param estimate estimate of the same events
     * @param options options that determine which events count
     * @return the figures
     * @throws IllegalArgumentException if truth and estimate differ in their number of events
     */
    public static Evaluation of(GroundTruth truth, FlowEstimate estimate, EvaluationOptions options) {
        int n = truth.size();
        if (estimate.size() != n) {
            throw new IllegalArgumentException("estimate must have as many events as the truth, " + n + ", but has "
                    + estimate.size());
        }
        ObjectIds ids = new ObjectIds(truth);
        int start = truth.firstCounted(options.skipFirstShare());
        double fastest = 0;
        for (int i = start; i < n; i++) {
            fastest = Math.max(fastest, ids.indexOf(i) < 0 ? 0 : truth.speed(i));
        }
        FlowFigures.Gatherer all = new FlowFigures.Gatherer(FlowFigures.ALL_OBJECTS, fastest);
        FlowFigures.Gatherer[] byObject = new FlowFigures.Gatherer[ids.count()];
        for (int o = 0; o < byObject.length; o++) {
            byObject[o] = new FlowFigures.Gatherer(ids.id(o), fastest);
        }
        long noise = 0;
        long noiseWithFlow = 0;
        for (int i = start; i < n; i++) {
            int object = ids.indexOf(i);
            if (object >= 0) {
                all.add(truth, estimate, i);
                byObject[object].add(truth, estimate, i);
            } else {
                noise++;
                noiseWithFlow += estimate.hasFlow(i) ? 1 : 0;
            }
        }
        List<FlowFigures> flowByObject = new ArrayList<>();
        for (FlowFigures.Gatherer object : byObject) {
            flowByObject.add(object.figures());
        }
        SegmentationFigures.Gatherer segmentation = segmentation(truth, estimate, ids, start, options.windowUs());
        List<SegmentationFigures> segmentationByObject = new ArrayList<>();
        for (int o = 0; o < ids.count(); o++) {
            segmentationByObject.add(segmentation.figures(o));
        }
        return new Evaluation(options, n, n - start, noise, noiseWithFlow, all.figures(), List.copyOf(flowByObject),
                segmentation.figuresOfAll(), List.copyOf(segmentationByObject),
                ConvergenceBin.of(truth, estimate, ids, options));
    }

    /**
     * Labels a simulated recording with a method and computes all figures.
     *
     * @param recording the recording to label
     * @param method a method made for the recording's sensor; it is not reset first
     * @param options options that determine which events count
     * @return the figures
     */
    public static Evaluation of(SimulatedRecording recording, EventLabeller method, EvaluationOptions options) {
        return of(GroundTruth.of(recording), FlowEstimate.of(recording, method), options);
    }

    private static SegmentationFigures.Gatherer segmentation(GroundTruth truth, FlowEstimate estimate, ObjectIds ids,
                                                             int start, long windowUs) {
        SegmentationFigures.Gatherer gatherer = new SegmentationFigures.Gatherer(truth, estimate, ids);
        int n = truth.size();
        int from = start;
        while (from < n) {
            // Windows begin at whole multiples of their length after the first counted event; empty ones are skipped.
            long elapsed = truth.timeUs()[from] - truth.timeUs()[start];
            long end = truth.timeUs()[start] + (elapsed / windowUs + 1) * windowUs;
            int until = from + 1;
            while (until < n && truth.timeUs()[until] < end) {
                until++;
            }
            gatherer.addWindow(from, until);
            from = until;
        }
        return gatherer;
    }

    /** {@return the share of the noise events that have flow} */
    public double noiseShareWithFlow() {
        return FlowFigures.share(noiseEventsWithFlow, noiseEvents);
    }
}
