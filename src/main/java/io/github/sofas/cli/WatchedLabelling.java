package io.github.sofas.cli;

import io.github.sofas.event.EventBatch;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.flow.Labelling;
import io.github.sofas.flow.Segment;
import java.util.List;

/** Labels as another does, and says after each batch how far it is. */
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
