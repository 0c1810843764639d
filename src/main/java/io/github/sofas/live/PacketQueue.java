package io.github.sofas.live;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSourceException;
import java.util.ArrayDeque;

/**
 * A bounded queue of event packets from the receiving thread to the consuming thread. All packets are allocated at the
 * start and reused. If the queue is full, the oldest packet in it is dropped, whole, and counted: the newest events
 * matter most to whoever watches a camera.
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
        /** When the packet came in, as {@link System#nanoTime()} counts. */
        long receivedNs;

        Packet(int capacity) {
            events = new EventBatch(capacity);
        }
    }

    /**
     * Makes an empty queue.
     *
     * @param limit greatest number of packets that wait in the queue
     * @param capacity greatest number of events in a packet
     */
    PacketQueue(int limit, int capacity) {
        this.limit = limit;
        // Besides the packets that wait, one is being filled and one is being consumed.
        free = new ArrayDeque<>(limit + 2);
        filled = new ArrayDeque<>(limit + 1);
        for (int i = 0; i < limit + 2; i++) {
            free.add(new Packet(capacity));
        }
    }

    /** An empty packet for the receiving thread, which fills one at a time. */
    synchronized Packet empty() {
        Packet packet = free.poll();
        if (packet == null) {
            throw new IllegalStateException("only one packet is filled at a time");
        }
        packet.events.clear();
        return packet;
    }

    /** Puts a packet into the queue; a packet without events is only made free again. */
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
     * Ends the queue: no more packets come. The packets that wait can still be taken.
     *
     * @param cause exception that {@link #take()} throws after the last packet; null for an end that was asked for
     */
    synchronized void end(EventSourceException cause) {
        if (!ended) {
            ended = true;
            failure = cause;
            notifyAll();
        }
    }

    /**
     * Takes the oldest packet, and waits for one if the queue is empty. The packet taken before becomes free again.
     *
     * @return the packet; null if the queue has ended
     * @throws EventSourceException if the queue has ended by a fault
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
