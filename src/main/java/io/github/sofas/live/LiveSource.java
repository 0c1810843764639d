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
 * A source of events as they happen: a camera or a network stream. A thread of the source receives the events and puts
 * them into a bounded queue. If the caller of {@link #next} falls behind, whole packets are dropped, oldest first, and
 * counted. All memory is allocated at the start and does not grow.
 */
public abstract class LiveSource implements EventSource {
    /** Most packets that wait in the queue: about half a second at 1 million events/s from a DAVIS. */
    private static final int QUEUE_PACKETS = 256;

    final PacketQueue queue;
    private final String name;
    private final Chip chip;
    private PacketQueue.Packet packet;
    private int delivered;
    private long receivedNs;
    private boolean stopped;
    /** Belongs to the receiving thread. */
    private long decodeNs;

    LiveSource(String name, Chip chip, int packetCapacity) {
        this.name = name;
        this.chip = chip;
        queue = new PacketQueue(QUEUE_PACKETS, packetCapacity);
    }

    /** {@return the name of the source in messages, such as "DAVIS240C 84010012"} */
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

    /** {@return the name of the stream's format, such as "DAVIS over USB"} */
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

    /** An empty packet for the data that has just come in. */
    final PacketQueue.Packet arrival() {
        PacketQueue.Packet empty = queue.empty();
        empty.receivedNs = System.nanoTime();
        return empty;
    }

    /** Puts a packet of {@link #arrival()}, with its decoded events, into the queue. */
    final void handOn(PacketQueue.Packet decoded) {
        decodeNs += System.nanoTime() - decoded.receivedNs;
        queue.offer(decoded);
    }

    /** {@return the time spent on decoding, in s; exact once the source is stopped} */
    public final double decodeS() {
        return decodeNs / 1e9;
    }

    /** {@return when the events of the last batch came in, as {@link System#nanoTime()} counts} */
    public final long receivedNs() {
        return receivedNs;
    }

    /**
     * Ends the stream: {@link #next} delivers the events that wait and then returns false. Any thread may call this,
     * more than once. Returns when nothing more comes in.
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

    /** Stops the reception, and returns when the receiving thread has ended. Called once. */
    abstract void shutDown();

    /** {@return the number of packets that wait now} */
    public final int packetsWaiting() {
        return queue.waiting();
    }

    /** {@return the number of packets that wait at most} */
    public final int queueLimit() {
        return queue.limit();
    }

    /** {@return the number of events dropped so far because the caller of {@link #next} fell behind} */
    public final long eventsDropped() {
        return queue.droppedEvents();
    }

    /** {@return the number of transfers or datagrams lost so far on their way here} */
    public abstract long packetsLost();

    /** {@return numbers of all that came in, by name; exact once the source is stopped} */
    public abstract Map<String, Long> counts();

    /** {@return numbers of events that came in but were not delivered, by reason; exact once the source is stopped} */
    public final Map<String, Long> dropped() {
        Map<String, Long> dropped = new LinkedHashMap<>(undecodable());
        dropped.put("engine_behind", queue.droppedEvents());
        return dropped;
    }

    /** Numbers of events that came in but make no sense, by reason. */
    abstract Map<String, Long> undecodable();

    /** {@return the faults that did not end the stream, one line each; exact once the source is stopped} */
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

    /** Releases the device or socket; may be called more than once. */
    abstract void release();
}
