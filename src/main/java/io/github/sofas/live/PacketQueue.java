package io.github.sofas.live;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSourceException;
import java.util.ArrayDeque;

/**
 * Packets of events on their way from the thread that they come in on to the thread that takes them. All packets are
 * made at the start and reused. Where the queue is full, the oldest packet in it is dropped, whole, and counted: what
 * is newest matters most to whoever watches a camera.
 */
final class PacketQueue {
    private final int limit;
    private final ArrayDeque<Packet> free;
    private final ArrayDeque<Packet> filled;
    private Packet taken;
    private boolean ended;
    private EventSourceException failure;
    private long droppedPackets;
    private long droppedEvents;

    /** The events of one transfer or datagram. */
    static final class Packet {
        final EventBatch events;
        /** When it came in, of {@link System#nanoTime()}. */
        long receivedNs;

        Packet(int capacity) {
            events = new EventBatch(capacity);
        }
    }

    /**
     * Makes an empty queue.
     *
     * @param limit the most packets that wait in it
     * @param capacity the most events of a packet
     */
    PacketQueue(int limit, int capacity) {
        this.limit = limit;
        // Beside those that wait, one is being filled and one is being taken.
        free = new ArrayDeque<>(limit + 2);
        filled = new ArrayDeque<>(limit + 1);
        for (int i = 0; i < limit + 2; i++) {
            free.add(new Packet(capacity));
        }
    }

    /** An empty packet for the filling thread, which has one at a time. */
    synchronized Packet empty() {
        Packet packet = free.poll();
        if (packet == null) {
            throw new IllegalStateException("only one packet is filled at a time");
        }
        packet.events.clear();
        return packet;
    }

    /** Hands over a packet; one without events is only given back. */
    synchronized void offer(Packet packet) {
        if (packet.events.size() == 0 || ended) {
            free.add(packet);
            return;
        }
        if (filled.size() == limit) {
            Packet oldest = filled.poll();
            droppedPackets++;
            droppedEvents += oldest.events.size();
            free.add(oldest);
        }
        filled.add(packet);
        notifyAll();
    }

    /**
     * Says that nothing more comes; what waits can still be taken.
     *
     * @param cause what {@link #take()} throws after the last packet; null for an end that was asked for
     */
    synchronized void end(EventSourceException cause) {
        if (!ended) {
            ended = true;
            failure = cause;
            notifyAll();
        }
    }

    /**
     * The oldest packet, waiting for one where there is none. The one taken before is given back.
     *
     * @return null where the queue has ended
     * @throws EventSourceException where it has ended by a fault
     */
    synchronized Packet take() throws EventSourceException {
        if (taken != null) {
            free.add(taken);
            taken = null;
        }
        try {
            while (filled.isEmpty() && !ended) {
                wait();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new EventSourceException("interrupted while waiting for events", e);
        }
        taken = filled.poll();
        if (taken == null && failure != null) {
            throw failure;
        }
        return taken;
    }

    synchronized int waiting() {
        return filled.size();
    }

    int limit() {
        return limit;
    }

    synchronized long droppedPackets() {
        return droppedPackets;
    }

    synchronized long droppedEvents() {
        return droppedEvents;
    }
}
