package io.github.sofas.cli;

import io.github.sofas.event.EventBatch;
import io.github.sofas.flow.EventLabeller;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.flow.Segment;
import java.util.List;

/** Labels as another does, and says after each batch how far it is. */
record WatchedLabeller(EventLabeller labeller, Runnable afterBatch) implements EventLabeller {
    @Override
    public void process(EventBatch batch, FlowOutput output) {
        labeller.process(batch, output);
        afterBatch.run();
    }

    @Override
    public List<Segment> segments() {
        return labeller.segments();
    }

    @Override
    public void reset() {
        labeller.reset();
    }
}
