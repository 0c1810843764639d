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
    /** A step back by more than this is no disorder but a clock set to zero, or a loop of a recording. */
    private static final int DISORDER_US = 10_000;
    /** How many of the events that follow say whether it is: half of them must go on from it. */
    private static final int WITNESSES = 8;
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
        for (int i = 0; i < batch.size(); i++) {
            batch.timeUs[i] = unwrap(i);
        }
    }

    private void add(PolarityEvent event, int y) {
        int n = batch.size();
        if (n == batch.capacity()) {
            grow();
        }
        events[n] = event;
        batch.add(event.timestamp, event.x, y, event.polarity == PolarityEvent.Polarity.On ? 1 : -1);
    }

    /** Time of an event for the engine. */
    private long unwrap(int i) {
        int timestamp = events[i].timestamp;
        if (!started) {
            started = true;
            timeUs = timestamp;
        } else {
            // the difference is right across the wrap from 2^31 - 1 to -2^31
            int step = timestamp - lastTimestamp;
            if (step < -DISORDER_US) {
                if (!othersGoOnFrom(i)) {
                    return timeUs + step;
                }
                timeUs += FORGOTTEN_US;
            } else {
                timeUs += step;
            }
        }
        lastTimestamp = timestamp;
        return timeUs;
    }

    /** Whether the events behind one that steps back lie nearer to it than to the one before. */
    private boolean othersGoOnFrom(int i) {
        int asked = Math.min(WITNESSES, batch.size() - 1 - i);
        int goOn = 0;
        for (int k = i + 1; k <= i + asked; k++) {
            int timestamp = events[k].timestamp;
            goOn += Math.abs(timestamp - events[i].timestamp) < Math.abs(timestamp - lastTimestamp) ? 1 : 0;
        }
        return 2 * goOn >= asked;
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
