package io.github.sofas.flow;

import java.util.List;
import java.util.function.Consumer;

/** One way of labelling events: as published, or refined. Called with events on the sensor whose time never falls. */
interface Method {
    /**
     * Labels an event.
     *
     * @param output takes flow and segment as its entry i
     */
    void label(int x, int y, long timeUs, int polarity, FlowOutput output, int i);

    /** Labels from now on with other parameters of the same preset. */
    void setParameters(SofasParameters parameters);

    /** Has a part of the work done by a helper; null for none. */
    default void helpedBy(Consumer<Runnable> helper) {
        // as published: in one thread
    }

    /** The living segments. */
    List<Segment> segments();

    /** The metrics of the flow plane. */
    MetricArray metricArray();

    /** Shows the pixels of a living segment's contour that are on the sensor; none for any other id. */
    void contour(int id, long nowUs, PixelConsumer pixels);

    /** Forgets all. */
    void reset();
}
