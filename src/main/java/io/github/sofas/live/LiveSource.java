package io.github.sofas.live;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSource;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.event.SensorSize;
import io.github.sofas.recording.Chip;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Events as they happen. They come in on a thread of their own and wait in a bounded queue; where the one who calls
 * {@link #next} falls behind, whole packets are dropped, oldest first, and counted. Memory is taken at the start and
 * does not grow.
 */
public abstract class LiveSource implements EventSource {
    /** Packets that wait at most: about half a second at 1 million events/s from a DAVIS. */
    private static final int QUEUE_PACKETS = 256;

    final PacketQueue queue;
    private final String name;
    private final Chip chip;
    private PacketQueue.Packet packet;
    private int delivered;
    private long receivedNs;
    private boolean stopped;
    /** Of the thread that events come in on. */
    private long decodeNs;

    LiveSource(String name, Chip chip, int packetCapacity) {
        this.name = name;
        this.chip = chip;
        queue = new PacketQueue(QUEUE_PACKETS, packetCapacity);
    }

    /** {@return what it is called in messages, such as "DAVIS240C 84010012"} */
    public final String name() {
        return name;
    }

    /** {@return the sensor chip} */
    public final Chip chip() {
        return chip;
    }

    @Override
    public final SensorSize sensor() {
        return chip.sensor();
    }

    /** {@return what the events come as, such as "DAVIS over USB"} */
    public abstract String formatName();

    @Override
    public final boolean next(EventBatch batch) throws EventSourceException {
        batch.clear();
        if (packet == null || delivered == packet.events.size()) {
            packet = queue.take();
            delivered = 0;
            if (packet == null) {
                return false;
            }
            receivedNs = packet.receivedNs;
        }
        EventBatch from = packet.events;
        int n = Math.min(batch.capacity(), from.size() - delivered);
        batch.addAll(from, delivered, n);
        delivered += n;
        return true;
    }

    /** An empty packet for what has come in just now. */
    final PacketQueue.Packet arrival() {
        PacketQueue.Packet empty = queue.empty();
        empty.receivedNs = System.nanoTime();
        return empty;
    }

    /** Hands on a packet that {@link #arrival()} gave, with its events. */
    final void handOn(PacketQueue.Packet decoded) {
        decodeNs += System.nanoTime() - decoded.receivedNs;
        queue.offer(decoded);
    }

    /** {@return the time spent on decoding, in seconds; exact once stopped} */
    public final double decodeS() {
        return decodeNs / 1e9;
    }

    /** {@return when the events of the last batch came in, of {@link System#nanoTime()}} */
    public final long receivedNs() {
        return receivedNs;
    }

    /**
     * Ends the stream: {@link #next} delivers what waits and then false. May be called by any thread, more than once;
     * returns when nothing more comes in.
     */
    public final void stop() {
        synchronized (this) {
            if (!stopped) {
                stopped = true;
                shutDown();
            }
        }
        queue.end(null);
    }

    /** Stops what comes in, and returns when the thread that it came in on is done. Called once. */
    abstract void shutDown();

    /** {@return packets that wait now} */
    public final int packetsWaiting() {
        return queue.waiting();
    }

    /** {@return packets that wait at most} */
    public final int queueLimit() {
        return queue.limit();
    }

    /** {@return events dropped so far because whoever takes them fell behind} */
    public final long eventsDropped() {
        return queue.droppedEvents();
    }

    /** {@return transfers or datagrams lost so far on their way here} */
    public abstract long packetsLost();

    /** {@return how many of each kind came in, by name; exact once stopped} */
    public abstract Map<String, Long> counts();

    /** {@return events that came in and were not delivered, by reason; exact once stopped} */
    public final Map<String, Long> dropped() {
        Map<String, Long> dropped = new LinkedHashMap<>(undecodable());
        dropped.put("engine_behind", queue.droppedEvents());
        return dropped;
    }

    /** Events that came in but make no sense, by reason. */
    abstract Map<String, Long> undecodable();

    /** {@return what went wrong without ending the stream, one line each; exact once stopped} */
    public final List<String> faults() {
        return describeFaults().stream().map(fault -> "[" + name + "] " + fault).toList();
    }

    /** The faults without the source's name. */
    abstract List<String> describeFaults();

    @Override
    public final void close() {
        stop();
        release();
    }

    /** Gives back what is held; may be called more than once. */
    abstract void release();
}
