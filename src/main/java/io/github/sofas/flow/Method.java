package io.github.sofas.flow;

import java.util.List;
import java.util.function.Consumer;

/**
 * One way of labelling events: as published, or refined. The caller passes only events on the sensor, in order of time.
 */
interface Method {
    /**
     * Labels an event.
     *
     * @param output takes flow and segment as its entry i
     */
    void label(int x, int y, long timeUs, int polarity, FlowOutput output, int i);

    /** Uses other parameters of the same preset from now on. */
    void setParameters(SofasParameters parameters);

    /** Has a helper do a part of the work; null for none. */
    default void helpedBy(Consumer<Runnable> helper) {
        // the published method runs in one thread
    }

    /** The living segments. */
    List<Segment> segments();

    /** The metrics of the flow plane. */
    MetricArray metricArray();

    /** Reports the pixels of a living segment's contour that are on the sensor; none for any other id. */
    void contour(int id, long nowUs, PixelConsumer pixels);

    /** Forgets all events and segments. */
    void reset();
}
