package io.github.sofas.flow.search;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.SofasParameters;
import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.motion.LoneEvents;

/**
 * The flow plane, the filters that keep events from it, and the search in it: everything that is learnt from the events
 * that no track plane explains. Events may come in slices ({@link EventSlice}), because another thread may learn from
 * one slice while the events of the next are labelled.
 */
public final class SearchedFlowPlane {
    private final SensorSize sensor;
    private final MetricFit fit;
    private final Structures structures;
    private SofasParameters.Search p;
    private LoneEvents lone;
    private BusyPixels busy;
    private FlowPlane plane;
    private StructureSearch search;

    /** Creates an empty flow plane, whose search hands the structures that it finds to {@code structures}. */
    public SearchedFlowPlane(SensorSize sensor, SofasParameters.Search p, MetricFit fit, Structures structures) {
        this.sensor = sensor;
        this.fit = fit;
        this.structures = structures;
        make(p, 0);
    }

    /** Most bytes of the arrays, except those of the fit. */
    public static long mostBytes(SensorSize sensor, SofasParameters.Search p) {
        return LoneEvents.bytes(sensor) + BusyPixels.bytes(sensor) + StructureSearch.mostBytes(sensor, p);
    }

    private void make(SofasParameters.Search with, long measuringVotes) {
        p = with;
        lone = new LoneEvents(sensor.width(), sensor.height(), p.slowestPxPerS());
        busy = new BusyPixels(sensor.width(), sensor.height(), p);
        plane = new FlowPlane(sensor.width(), sensor.height(), p);
        search = new StructureSearch(plane, p, fit, structures, measuringVotes);
    }

    /**
     * Takes an event unless it is explained, and searches as far as is due with this event.
     *
     * @param measuringVotes votes that the measurements of track planes gave so far
     */
    public void take(int x, int y, long timeUs, int polarity, boolean isExplained, long measuringVotes) {
        add(x, y, timeUs, polarity, isExplained);
        search.run(measuringVotes, timeUs);
    }

    private void add(int x, int y, long timeUs, int polarity, boolean isExplained) {
        if (!isExplained && !lone.isAlone(x, y, timeUs) && !busy.isBusy(x, y, timeUs)) {
            plane.add(x, y, timeUs, polarity);
        }
        settle(timeUs);
    }

    /** Lets a tracked structure that is due look around itself. Not to be called while another thread tracks it. */
    public void spread() {
        search.spread();
    }

    /**
     * Takes the events of a slice, and searches as far as is due with them.
     *
     * @param measuringVotes votes that the measurements of track planes gave so far
     */
    public void take(EventSlice slice, long measuringVotes) {
        int place = 0;
        for (int i = 0; i < slice.size(); i++) {
            search(slice.place(i) - 1 - place, measuringVotes, slice.timeUs(i));
            place = slice.place(i);
            boolean isTaken = structures.takes(slice.x(i), slice.y(i), slice.timeUs(i), slice.sign(i));
            add(slice.x(i), slice.y(i), slice.timeUs(i), slice.sign(i), isTaken);
            search(1, measuringVotes, slice.timeUs(i));
        }
        if (slice.labelled() > place) {
            settle(slice.untilUs());
            search(slice.labelled() - place, measuringVotes, slice.untilUs());
        }
    }

    private void settle(long nowUs) {
        if (plane.mustSettle(nowUs)) {
            plane.settle(nowUs);
        }
    }

    private void search(int events, long measuringVotes, long nowUs) {
        for (int i = 0; i < events; i++) {
            search.run(measuringVotes, nowUs, false);
        }
    }

    /** Continues with other parameters. All events are forgotten where these change the projections or the lifespan. */
    public void setParameters(SofasParameters.Search next, long measuringVotes) {
        if (next.flowProjections() != p.flowProjections() || next.slowestPxPerS() != p.slowestPxPerS()
                || next.fastestPxPerS() != p.fastestPxPerS() || next.lifespanUs() != p.lifespanUs()) {
            make(next, measuringVotes);
        } else {
            search.setParameters(next);
            p = next;
        }
    }

    /** Metric per event held of each projection, for display; 0 for a projection that holds no events. */
    public float[] metricsPerEvent() {
        return plane.metricsPerEvent();
    }

    /** Forgets all events. */
    public void reset() {
        lone.reset();
        busy.reset();
        plane.reset();
        search.reset();
    }
}
