package io.github.sofas.jaer;

import io.github.sofas.event.EventBatch;
import io.github.sofas.flow.FlowOutput;
import java.util.Arrays;
import net.sf.jaer.event.PolarityEvent;

/**
 * The polarity events of a packet of jAER, in the engine's axes, and the flow that the engine gives them. Packets are
 * reused, and their arrays grow to the size of the largest packet. One thread at a time uses a packet: first the
 * viewer's, then the engine's, then the viewer's again.
 */
final class LabelledPacket {
    private EventBatch batch = new EventBatch(4096);
    private FlowOutput flow = new FlowOutput(4096);
    private PolarityEvent[] events = new PolarityEvent[4096];
    /** Copies of events that outlive jAER's packet, which jAER reuses. */
    private PolarityEvent[] copies = new PolarityEvent[0];
    private Snapshot snapshot;
    private long readNs;
    private long engineNs;

    void clear() {
        batch.clear();
        snapshot = null;
    }

    /** Adds an event. The engine's time of the event is set later. */
    void add(PolarityEvent event, int y) {
        int n = batch.size();
        if (n == batch.capacity()) {
            grow();
        }
        events[n] = event;
        batch.add(event.timestamp, event.x, y, event.polarity == PolarityEvent.Polarity.On ? 1 : -1);
    }

    private void grow() {
        EventBatch larger = new EventBatch(2 * batch.capacity());
        for (int i = 0; i < batch.size(); i++) {
            larger.add(batch.timeUs[i], batch.x[i], batch.y[i], batch.polarity[i]);
        }
        batch = larger;
        flow = new FlowOutput(larger.capacity());
        events = Arrays.copyOf(events, larger.capacity());
    }

    /** Copies the events, so that they no longer depend on jAER's packet. */
    void keepEvents() {
        int n = batch.size();
        int before = copies.length;
        if (n > before) {
            copies = Arrays.copyOf(copies, events.length);
            for (int i = before; i < copies.length; i++) {
                copies[i] = new PolarityEvent();
            }
        }
        for (int i = 0; i < n; i++) {
            copies[i].copyFrom(events[i]);
            events[i] = copies[i];
        }
    }

    /** The events, in the axes of the engine. */
    EventBatch batch() {
        return batch;
    }

    /** The flow of the events, which the engine writes. */
    FlowOutput flow() {
        return flow;
    }

    /** An event as an object of jAER. */
    PolarityEvent event(int i) {
        return events[i];
    }

    /** The state of the engine after this packet; null if no snapshot was wanted. */
    Snapshot snapshot() {
        return snapshot;
    }

    void setSnapshot(Snapshot snapshot) {
        this.snapshot = snapshot;
    }

    long readNs() {
        return readNs;
    }

    void setReadNs(long readNs) {
        this.readNs = readNs;
    }

    long engineNs() {
        return engineNs;
    }

    void setEngineNs(long engineNs) {
        this.engineNs = engineNs;
    }
}
