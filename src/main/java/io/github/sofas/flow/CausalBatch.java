package io.github.sofas.flow;

import io.github.sofas.event.EventBatch;
import java.util.ArrayList;
import java.util.List;

/**
 * Events with the labels that a camera would get, and the findings about segments in between. The first step of
 * {@link SmoothedSofas} hands it to the second. Made once for each batch on its way, and reused.
 */
public final class CausalBatch {
    private static final int FIRST_CAPACITY = 8192;

    private EventBatch events = new EventBatch(FIRST_CAPACITY);
    private FlowOutput labels = new FlowOutput(FIRST_CAPACITY);
    /** What to do with each finding, and how many of the events come before it. */
    private final List<Runnable> findings = new ArrayList<>();
    private final List<Integer> eventsBefore = new ArrayList<>();

    /** Takes an event with its causal label. */
    @FunctionalInterface
    interface Events {
        void take(EventBatch events, FlowOutput labels, int i);
    }

    /** Makes an empty one. */
    public CausalBatch() {
    }

    void clear() {
        events.clear();
        findings.clear();
        eventsBefore.clear();
    }

    /** Appends what to do after the events added so far. */
    void add(Runnable finding) {
        findings.add(finding);
        eventsBefore.add(events.size());
    }

    /** Appends labelled events. */
    void add(EventBatch part, FlowOutput causal) {
        int from = events.size();
        int size = from + part.size();
        if (size > events.capacity()) {
            EventBatch more = new EventBatch(2 * size);
            more.addAll(events, 0, from);
            FlowOutput moreLabels = new FlowOutput(2 * size);
            copy(labels, moreLabels, 0, from);
            events = more;
            labels = moreLabels;
        }
        events.addAll(part, 0, part.size());
        copy(causal, labels, from, part.size());
    }

    private static void copy(FlowOutput from, FlowOutput to, int at, int count) {
        System.arraycopy(from.segment, 0, to.segment, at, count);
        System.arraycopy(from.vxPxPerS, 0, to.vxPxPerS, at, count);
        System.arraycopy(from.vyPxPerS, 0, to.vyPxPerS, at, count);
    }

    /** Replays events and findings in the order in which they came: hands over each event, and runs each finding. */
    void replay(Events to) {
        int next = 0;
        for (int i = 0; i <= events.size(); i++) {
            while (next < findings.size() && eventsBefore.get(next) == i) {
                findings.get(next++).run();
            }
            if (i < events.size()) {
                to.take(events, labels, i);
            }
        }
    }
}
