package io.github.sofas.jaer;

import io.github.sofas.event.SensorSize;
import java.util.Iterator;
import net.sf.jaer.event.ApsDvsEvent;
import net.sf.jaer.event.ApsDvsEventPacket;
import net.sf.jaer.event.BasicEvent;
import net.sf.jaer.event.EventPacket;
import net.sf.jaer.event.PolarityEvent;

/**
 * Reads the polarity events of a packet of jAER for the engine: y turned, time unwrapped, what is no event of the
 * sensor left out.
 */
final class PacketAdapter {
    /** A step back by more than this is no disorder but a clock set to zero, or a loop of a recording. */
    private static final int DISORDER_US = 10_000;
    /** How many of the events that follow say whether it is: half of them must go on from it. */
    private static final int WITNESSES = 8;
    /** Time that passes for the engine when a clock was set: no event lives so long. */
    private static final long FORGOTTEN_US = 120_000_000;

    private int lastTimestamp;
    private long timeUs;
    private boolean started;

    /** Takes the events of a packet. */
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

    /** Time of an event for the engine. */
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

    /** Whether the events behind one that steps back lie nearer to it than to the one before. */
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

    /** All objects of a packet, with the samples of an inertial sensor where it has them. */
    static Iterator<? extends BasicEvent> all(EventPacket<?> packet) {
        return packet instanceof ApsDvsEventPacket ? ((ApsDvsEventPacket<? extends ApsDvsEvent>) packet).fullIterator()
            : packet.iterator();
    }

    /** Begins anew: the next event's time is taken as it is. */
    void reset() {
        started = false;
    }
}
