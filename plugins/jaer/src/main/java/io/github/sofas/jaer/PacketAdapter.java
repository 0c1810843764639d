package io.github.sofas.jaer;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.FlowOutput;
import java.util.Arrays;
import java.util.Iterator;
import net.sf.jaer.event.ApsDvsEvent;
import net.sf.jaer.event.ApsDvsEventPacket;
import net.sf.jaer.event.BasicEvent;
import net.sf.jaer.event.EventPacket;
import net.sf.jaer.event.PolarityEvent;

/**
 * The polarity events of a packet of jAER as a batch for the engine: y turned, time unwrapped, what is no event of the
 * sensor left out. Arrays grow to the largest packet and are used again.
 */
final class PacketAdapter {
    /** A step back by more than this is no disorder but a clock set to zero. */
    private static final int CLOCK_WAS_SET_US = 1_000_000;
    /** Time that passes for the engine when a clock was set: no event lives so long. */
    private static final long FORGOTTEN_US = 120_000_000;

    private EventBatch batch = new EventBatch(4096);
    private FlowOutput output = new FlowOutput(4096);
    private PolarityEvent[] events = new PolarityEvent[4096];
    private int lastTimestamp;
    private long timeUs;
    private boolean started;

    /** Takes the events of a packet; those of the one before are gone. */
    void read(EventPacket<?> packet, SensorSize sensor) {
        batch.clear();
        Iterator<?> iterator = packet.iterator();
        while (iterator.hasNext()) {
            Object next = iterator.next();
            if (next instanceof PolarityEvent) {
                PolarityEvent event = (PolarityEvent) next;
                int y = sensor.height() - 1 - event.y;
                if (!event.isSpecial() && sensor.contains(event.x, y)) {
                    add(event, y);
                }
            }
        }
    }

    private void add(PolarityEvent event, int y) {
        int n = batch.size();
        if (n == batch.capacity()) {
            grow();
        }
        events[n] = event;
        batch.add(unwrap(event.timestamp), event.x, y, event.polarity == PolarityEvent.Polarity.On ? 1 : -1);
    }

    private long unwrap(int timestamp) {
        if (!started) {
            started = true;
            timeUs = timestamp;
        } else {
            // the difference is right across the wrap from 2^31 - 1 to -2^31
            int step = timestamp - lastTimestamp;
            timeUs += step < -CLOCK_WAS_SET_US ? FORGOTTEN_US : step;
        }
        lastTimestamp = timestamp;
        return timeUs;
    }

    private void grow() {
        EventBatch larger = new EventBatch(2 * batch.capacity());
        for (int i = 0; i < batch.size(); i++) {
            larger.add(batch.timeUs[i], batch.x[i], batch.y[i], batch.polarity[i]);
        }
        batch = larger;
        output = new FlowOutput(larger.capacity());
        events = Arrays.copyOf(events, larger.capacity());
    }

    /** The events, in the axes of the engine. */
    EventBatch batch() {
        return batch;
    }

    /** Where the engine puts their flow. */
    FlowOutput output() {
        return output;
    }

    /** An event as jAER has it; until the next packet. */
    PolarityEvent event(int i) {
        return events[i];
    }

    /** All objects of a packet, with the samples of an inertial sensor where it has them. */
    static Iterator<? extends BasicEvent> all(EventPacket<?> packet) {
        return packet instanceof ApsDvsEventPacket ? ((ApsDvsEventPacket<? extends ApsDvsEvent>) packet).fullIterator()
            : packet.iterator();
    }

    /** Begins anew: the next event's time is taken as it is. */
    void reset() {
        batch.clear();
        started = false;
    }
}
