package io.github.sofas.live;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertSame;
import static org.junit.Assert.assertThrows;

import io.github.sofas.event.EventSourceException;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.Set;
import org.junit.Test;

public class PacketQueueTest {
    private final PacketQueue queue = new PacketQueue(2, 4);

    /** Offers a packet of so many events at a time. */
    private PacketQueue.Packet offer(long timeUs, int events) {
        PacketQueue.Packet packet = queue.empty();
        for (int i = 0; i < events; i++) {
            packet.events.add(timeUs, 0, 0, 1);
        }
        queue.offer(packet);
        return packet;
    }

    private long takeTimeUs() throws EventSourceException {
        return queue.take().events.timeUs[0];
    }

    @Test
    public void givesPacketsInTheirOrder() throws EventSourceException {
        offer(1, 1);
        offer(2, 1);
        assertEquals(2, queue.waiting());
        assertEquals(1, takeTimeUs());
        assertEquals(2, takeTimeUs());
        assertEquals(0, queue.droppedPackets());
    }

    @Test
    public void dropsTheOldestWholePacketsAndCountsThem() throws EventSourceException {
        offer(1, 3);
        offer(2, 4);
        offer(3, 1);
        offer(4, 1);
        assertEquals(2, queue.droppedPackets());
        assertEquals(7, queue.droppedEvents());
        assertEquals(3, takeTimeUs());
        assertEquals(4, takeTimeUs());
    }

    @Test
    public void neverDropsThePacketThatIsBeingTaken() throws EventSourceException {
        offer(1, 1);
        PacketQueue.Packet taken = queue.take();
        for (int t = 2; t < 10; t++) {
            offer(t, 1);
        }
        assertEquals(1, taken.events.timeUs[0]);
        assertEquals(8, takeTimeUs());
    }

    @Test
    public void usesNoMorePacketsThanItStartedWith() throws EventSourceException {
        Set<Object> seen = Collections.newSetFromMap(new IdentityHashMap<>());
        for (int t = 0; t < 100; t++) {
            seen.add(offer(t, 1));
            if (t % 7 == 0) {
                seen.add(queue.take());
            }
        }
        // two wait, one is filled, one is taken
        assertEquals(4, seen.size());
    }

    @Test
    public void keepsNoPacketWithoutEvents() throws EventSourceException {
        for (int i = 0; i < 10; i++) {
            offer(1, 0);
        }
        assertEquals(0, queue.waiting());
        queue.end(null);
        assertNull(queue.take());
    }

    @Test
    public void givesWhatWaitsBeforeItsEnd() throws EventSourceException {
        offer(1, 1);
        queue.end(null);
        offer(2, 1);
        assertEquals(1, takeTimeUs());
        assertNull(queue.take());
        assertNull(queue.take());
    }

    @Test
    public void throwsItsFaultAfterTheLastPacket() throws EventSourceException {
        offer(1, 1);
        EventSourceException unplugged = new EventSourceException("unplugged");
        queue.end(unplugged);
        queue.end(null);
        assertEquals(1, takeTimeUs());
        assertSame(unplugged, assertThrows(EventSourceException.class, queue::take));
    }

    @Test
    public void waitsForAPacket() throws Exception {
        Thread later = new Thread(() -> offer(5, 1));
        later.start();
        assertEquals(5, takeTimeUs());
        later.join();
    }
}
