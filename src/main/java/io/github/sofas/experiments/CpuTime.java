package io.github.sofas.experiments;

import io.github.sofas.event.EventBatch;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.flow.Labelling;
import io.github.sofas.flow.Segment;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.List;

/**
 * A method that measures the processor time of its labelling. The time is that of the calling thread, so that other
 * work on the machine does not count.
 */
final class CpuTime implements Labelling {
    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

    private final Labelling method;
    private long ns;
    private long events;

    CpuTime(Labelling method) {
        this.method = method;
    }

    @Override
    public void add(EventBatch batch) {
        long start = THREADS.getCurrentThreadCpuTime();
        method.add(batch);
        ns += THREADS.getCurrentThreadCpuTime() - start;
        events += batch.size();
    }

    @Override
    public void finish() {
        long start = THREADS.getCurrentThreadCpuTime();
        method.finish();
        ns += THREADS.getCurrentThreadCpuTime() - start;
    }

    @Override
    public boolean next(EventBatch batch, FlowOutput flow) {
        long start = THREADS.getCurrentThreadCpuTime();
        boolean labelled = method.next(batch, flow);
        ns += THREADS.getCurrentThreadCpuTime() - start;
        return labelled;
    }

    @Override
    public List<Segment> segments() {
        return method.segments();
    }

    /** Processor time per event, in ns; 0 if there was no event. */
    double nsPerEvent() {
        return events == 0 ? 0 : (double) ns / events;
    }
}
