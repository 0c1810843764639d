package io.github.sofas.cli;

import io.github.sofas.event.EventBatch;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.flow.Labelling;
import io.github.sofas.flow.Segment;
import java.util.List;

/**
 * Labels as another labelling does, and runs an action after each batch that was added, such as a display of progress.
 */
record WatchedLabelling(Labelling labelling, Runnable afterBatch) implements Labelling {
    @Override
    public void add(EventBatch batch) {
        labelling.add(batch);
        afterBatch.run();
    }

    @Override
    public void finish() {
        labelling.finish();
    }

    @Override
    public boolean next(EventBatch batch, FlowOutput flow) {
        return labelling.next(batch, flow);
    }

    @Override
    public List<Segment> segments() {
        return labelling.segments();
    }
}
