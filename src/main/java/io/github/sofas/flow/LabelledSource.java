package io.github.sofas.flow;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSource;
import io.github.sofas.event.EventSourceException;

/** The events of a source with their labels. If the source is damaged, all events before the damage come first. */
public final class LabelledSource {
    private static final int BATCH = 4096;

    private final EventSource source;
    private final Labelling labelling;
    private final EventBatch read = new EventBatch(BATCH);
    private EventSourceException damage;
    private boolean ended;
    private long labellingNs;

    /**
     * Begins at the present position of the source.
     *
     * @param source read to its end or its damage, not closed
     * @param labelling made for the source's sensor
     */
    public LabelledSource(EventSource source, Labelling labelling) {
        this.source = source;
        this.labelling = labelling;
    }

    /**
     * Clears a batch, and fills it with the events that follow.
     *
     * @param batch gets the events
     * @param flow takes entry i for event i of the batch; holds at least as many
     * @return false at the end, with the batch left empty; otherwise true, with at least one event
     * @throws EventSourceException if the source is damaged and no further event can be had
     */
    public boolean next(EventBatch batch, FlowOutput flow) throws EventSourceException {
        while (true) {
            long start = System.nanoTime();
            boolean labelled = labelling.next(batch, flow);
            labellingNs += System.nanoTime() - start;
            if (labelled) {
                return true;
            }
            if (ended) {
                if (damage != null) {
                    throw damage;
                }
                return false;
            }
            read();
        }
    }

    private void read() {
        try {
            ended = !source.next(read);
        } catch (EventSourceException e) {
            damage = e;
            ended = true;
        }
        long start = System.nanoTime();
        if (ended) {
            labelling.finish();
        } else {
            labelling.add(read);
        }
        labellingNs += System.nanoTime() - start;
    }

    /** {@return the time that labelling took so far, in ns; reading the source is not included} */
    public long labellingNs() {
        return labellingNs;
    }
}
