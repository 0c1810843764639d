package io.github.sofas.evaluate;

import java.util.ArrayList;
import java.util.List;

/**
 * Error of the flow at a given time after an object appears, over all objects. A sequence of bins shows how fast a
 * method converges. An object appears with its first event in the recording; the beginning of the recording counts,
 * too.
 *
 * @param fromUs time since appearance at which the bin begins, in µs
 * @param untilUs time since appearance at which the bin ends, exclusive, in µs
 * @param events number of object events in the bin
 * @param eventsWithFlow number of those events that have flow
 * @param meanMagnitudeErrorPercent mean signed magnitude error in %, 0 if no event has flow
 * @param meanAngularErrorDeg mean unsigned angular error in degrees, 0 if no event has flow
 * @param meanEndpointErrorPxPerS mean endpoint error in px/s, 0 if no event has flow
 * @param meanRelativeEndpointErrorPercent mean relative endpoint error in %, 0 if no event has flow
 */
public record ConvergenceBin(long fromUs, long untilUs, long events, long eventsWithFlow,
                             double meanMagnitudeErrorPercent, double meanAngularErrorDeg,
                             double meanEndpointErrorPxPerS, double meanRelativeEndpointErrorPercent) {

    static List<ConvergenceBin> of(GroundTruth truth, FlowEstimate estimate, ObjectIds ids,
                                   EvaluationOptions options) {
        FlowFigures.Gatherer[] bins = new FlowFigures.Gatherer[options.convergenceBins()];
        for (int b = 0; b < bins.length; b++) {
            bins[b] = new FlowFigures.Gatherer(FlowFigures.ALL_OBJECTS, Double.POSITIVE_INFINITY);
        }
        for (int i = 0; i < truth.size(); i++) {
            int object = ids.indexOf(i);
            if (object < 0) {
                continue;
            }
            long bin = (truth.timeUs()[i] - truth.timeUs()[ids.firstEvent(object)]) / options.convergenceBinUs();
            if (bin < bins.length) {
                bins[(int) bin].add(truth, estimate, i);
            }
        }
        List<ConvergenceBin> result = new ArrayList<>();
        for (int b = 0; b < bins.length; b++) {
            FlowFigures figures = bins[b].figures();
            result.add(new ConvergenceBin(b * options.convergenceBinUs(), (b + 1) * options.convergenceBinUs(),
                    figures.events(), figures.eventsWithFlow(), figures.magnitudeErrorPercent().mean(),
                    figures.angularErrorDeg().mean(), figures.endpointErrorPxPerS().mean(),
                    figures.relativeEndpointErrorPercent().mean()));
        }
        return List.copyOf(result);
    }

    /** {@return the share of the bin's events that have flow} */
    public double shareWithFlow() {
        return FlowFigures.share(eventsWithFlow, events);
    }
}
