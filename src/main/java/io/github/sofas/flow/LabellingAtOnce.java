package io.github.sofas.flow;

import io.github.sofas.event.EventBatch;
import java.util.List;

/** Labels events without look-ahead: holds them until they are asked for, and labels them then. */
final class LabellingAtOnce implements Labelling {
    private static final int FIRST_CAPACITY = 4096;

    private final EventLabeller method;
    private EventBatch waiting = new EventBatch(FIRST_CAPACITY);
    private int given;

    LabellingAtOnce(EventLabeller method) {
        this.method = method;
    }

    @Override
    public void add(EventBatch batch) {
        int left = waiting.size() - given;
        if (given > 0 || left + batch.size() > waiting.capacity()) {
            EventBatch next = left + batch.size() > waiting.capacity() ? new EventBatch(2 * (left + batch.size()))
                : waiting;
            if (left > 0) {
                EventBatch held = new EventBatch(left);
                held.addAll(waiting, given, left);
                next.clear();
                next.addAll(held, 0, left);
            } else {
                next.clear();
            }
            waiting = next;
            given = 0;
        }
        waiting.addAll(batch, 0, batch.size());
    }

    @Override
    public void finish() {
        // nothing is held back
    }

    @Override
    public boolean next(EventBatch batch, FlowOutput flow) {
        batch.clear();
        int count = Math.min(Math.min(batch.capacity(), flow.capacity()), waiting.size() - given);
        if (count == 0) {
            return false;
        }
        batch.addAll(waiting, given, count);
        given += count;
        method.process(batch, flow);
        return true;
    }

    @Override
    public List<Segment> segments() {
        return method.segments();
    }
}
