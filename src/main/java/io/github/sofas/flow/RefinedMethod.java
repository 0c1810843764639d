package io.github.sofas.flow;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.motion.MeasuredMotions;
import io.github.sofas.flow.search.EventRate;
import io.github.sofas.flow.search.EventSlice;
import io.github.sofas.flow.search.SearchedFlowPlane;
import io.github.sofas.flow.track.TrackPlaneStack;
import java.util.List;
import java.util.function.Consumer;

/**
 * The method of the {@code default} preset: the paper's nouns, made accurate and fast. An event goes to the track plane
 * that expects it, otherwise to the flow plane. A structure that the search finds there becomes a track plane.
 *
 * <p>Ours: where many events are explained, the flow plane gets them in slices, so that a helper may search one slice
 * while the next is labelled. A structure found in a slice is tracked from the end of that next slice on, whoever
 * searched, and however fast.
 */
final class RefinedMethod implements Method {
    /** Most events of a track plane that vote on two grids, which costs twice as much. */
    private static final int TRACKED_ON_BOTH = 1000;
    /** The same for a piece of the flow plane, whose velocity needs to be right to a few percent only. */
    private static final int SEARCHED_ON_BOTH = 300;

    private final SensorSize sensor;
    private final TrackPlaneStack stack;
    private final SearchedFlowPlane flowPlane;
    private final EventRate rate = new EventRate();
    private final EventSlice.Taker expecting;
    private final Beside learning;
    private SofasParameters p;
    /** The slice that is labelled now, and the slice before it, which the flow plane was given. */
    private EventSlice slice = new EventSlice();
    private EventSlice given = new EventSlice();
    /** Votes of measurements when that slice was given. */
    private long givenVotes;

    RefinedMethod(SensorSize sensor, SofasParameters p, Consumer<Segment> ended, MeasuredMotions measured) {
        this.sensor = sensor;
        this.p = p;
        stack = new TrackPlaneStack(sensor, p.track(), newFit(TRACKED_ON_BOTH), newFit(TRACKED_ON_BOTH), ended,
            measured);
        flowPlane = new SearchedFlowPlane(sensor, p.search(), newFit(SEARCHED_ON_BOTH),
            new FoundStructures(stack));
        expecting = stack.found()::takes;
        learning = new Beside(() -> flowPlane.take(given, givenVotes));
    }

    private MetricFit newFit(int mostOnBoth) {
        return new MetricFit(sensor.width(), sensor.height(), MetricFit.CELL_PX, TrackPlaneStack.MOST_MEASURED,
            mostOnBoth);
    }

    static long mostBytes(SensorSize sensor, SofasParameters p) {
        long fit = MetricFit.bytes(sensor.width(), sensor.height(), MetricFit.CELL_PX,
            TrackPlaneStack.MOST_MEASURED);
        return SearchedFlowPlane.mostBytes(sensor, p.search()) + TrackPlaneStack.mostBytes(sensor, p.track())
            + 3 * fit + 2 * EventSlice.bytes();
    }

    @Override
    public void label(int x, int y, long timeUs, int polarity, FlowOutput output, int i) {
        rate.goOn(timeUs);
        if (!rate.isDense()) {
            labelAlone(x, y, timeUs, polarity, output, i);
            return;
        }
        if (slice.isOver(timeUs)) {
            learn();
        }
        stack.check(timeUs);
        boolean explained = stack.label(x, y, timeUs, polarity, output, i);
        rate.note(explained);
        slice.add(x, y, timeUs, polarity, explained);
    }

    /** Labels an event, and has the flow plane learn from it at once. */
    private void labelAlone(int x, int y, long timeUs, int polarity, FlowOutput output, int i) {
        if (slice.labelled() > 0) {
            catchUp();
        }
        stack.check(timeUs);
        boolean explained = stack.label(x, y, timeUs, polarity, output, i);
        rate.note(explained);
        flowPlane.take(x, y, timeUs, polarity, explained, stack.votes());
        stack.adopt();
    }

    /** Learns from the last slice of a dense time as well, before the events that follow are labelled. */
    private void catchUp() {
        learn();
        learning.await();
        stack.adopt();
    }

    /** Tracks the structures found in the slice before, and gives the finished slice to the flow plane. */
    private void learn() {
        learning.await();
        slice.offer(expecting);
        stack.adopt();
        flowPlane.spread();
        EventSlice next = given;
        given = slice;
        slice = next;
        slice.clear();
        givenVotes = stack.votes();
        learning.begin();
    }

    @Override
    public void setParameters(SofasParameters next) {
        learning.await();
        stack.setParameters(next.track());
        flowPlane.setParameters(next.search(), stack.votes());
        p = next;
    }

    @Override
    public void helpedBy(Consumer<Runnable> helper) {
        learning.helpedBy(helper);
    }

    @Override
    public List<Segment> segments() {
        return stack.segments();
    }

    @Override
    public MetricArray metricArray() {
        learning.await();
        return new MetricArray(SofasParameters.Preset.DEFAULT, p.search().flowProjections(),
            flowPlane.metricsPerEvent());
    }

    @Override
    public void contour(int id, long nowUs, PixelConsumer pixels) {
        stack.contour(id, nowUs, pixels);
    }

    @Override
    public void reset() {
        learning.await();
        slice.clear();
        rate.reset();
        flowPlane.reset();
        stack.reset();
    }
}
