package io.github.sofas.jaer;

import io.github.sofas.event.SensorSize;
import java.util.Iterator;
import net.sf.jaer.event.ApsDvsEvent;
import net.sf.jaer.event.ApsDvsEventPacket;
import net.sf.jaer.event.BasicEvent;
import net.sf.jaer.event.EventPacket;
import net.sf.jaer.event.PolarityEvent;

/**
 * Reads the polarity events of a packet of jAER for the engine. It converts y to the engine's axes, unwraps the time,
 * and leaves out special events and events outside the sensor.
 */
final class PacketAdapter {
    /** A step back by more than this is not disorder, but a clock set to zero or a recording that starts again. */
    private static final int DISORDER_US = 10_000;
    /** Number of following events that decide whether a step back is real: half of them must continue from it. */
    private static final int WITNESSES = 8;
    /** Time that passes for the engine when a clock was set to zero: no event lives so long. */
    private static final long FORGOTTEN_US = 120_000_000;

    private int lastTimestamp;
    private long timeUs;
    private boolean started;

    /** Reads the events of a packet. */
    void read(EventPacket<?> packet, SensorSize sensor, LabelledPacket into) {
        into.clear();
        Iterator<?> iterator = packet.iterator();
        while (iterator.hasNext()) {
            Object next = iterator.next();
            if (next instanceof PolarityEvent) {
                PolarityEvent event = (PolarityEvent) next;
                int y = sensor.height() - 1 - event.y;
                if (!event.isSpecial() && sensor.contains(event.x, y)) {
                    into.add(event, y);
                }
            }
        }
        for (int i = 0; i < into.batch().size(); i++) {
            into.batch().timeUs[i] = unwrap(into, i);
        }
    }

    /** The time of an event for the engine. */
    private long unwrap(LabelledPacket packet, int i) {
        int timestamp = packet.event(i).timestamp;
        if (!started) {
            started = true;
            timeUs = timestamp;
        } else {
            // the difference is right across the wrap from 2^31 - 1 to -2^31
            int step = timestamp - lastTimestamp;
            if (step < -DISORDER_US) {
                if (!othersGoOnFrom(packet, i)) {
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

    /** Whether the events after one that steps back are nearer in time to that event than to the event before it. */
    private boolean othersGoOnFrom(LabelledPacket packet, int i) {
        int asked = Math.min(WITNESSES, packet.batch().size() - 1 - i);
        int from = packet.event(i).timestamp;
        int goOn = 0;
        for (int k = i + 1; k <= i + asked; k++) {
            int timestamp = packet.event(k).timestamp;
            goOn += Math.abs(timestamp - from) < Math.abs(timestamp - lastTimestamp) ? 1 : 0;
        }
        return 2 * goOn >= asked;
    }

    /** All objects of a packet, including samples of an inertial sensor if the packet has them. */
    static Iterator<? extends BasicEvent> all(EventPacket<?> packet) {
        return packet instanceof ApsDvsEventPacket ? ((ApsDvsEventPacket<? extends ApsDvsEvent>) packet).fullIterator()
            : packet.iterator();
    }

    /** Starts again: the time of the next event is taken as it is. */
    void reset() {
        started = false;
    }
}
