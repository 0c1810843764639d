package io.github.sofas.experiments;

import io.github.sofas.event.EventBatch;
import io.github.sofas.flow.EventLabeller;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.flow.Segment;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.List;

/** A method and the processor time that its labelling took in the thread that uses it, whoever else is at work. */
final class CpuTime implements EventLabeller {
    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

    private final EventLabeller method;
    private long ns;
    private long events;

    CpuTime(EventLabeller method) {
        this.method = method;
    }

    @Override
    public void process(EventBatch batch, FlowOutput output) {
        long start = THREADS.getCurrentThreadCpuTime();
        method.process(batch, output);
        ns += THREADS.getCurrentThreadCpuTime() - start;
        events += batch.size();
    }

    @Override
    public List<Segment> segments() {
        return method.segments();
    }

    @Override
    public void reset() {
        method.reset();
    }

    /** Processor time for each event, in ns; 0 where there was none. */
    double nsPerEvent() {
        return events == 0 ? 0 : (double) ns / events;
    }
}
