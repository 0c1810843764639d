package io.github.sofas.benchmark;

import io.github.sofas.event.EventBatch;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.flow.Sofas;
import java.util.List;

/**
 * Latency of the engine as a live camera would experience it: how long each packet takes to get its labels.
 *
 * @param ofOneMs time that the engine works on each packet of 1 ms of the recording, one packet after the other without
 *     a pause
 * @param paced time from when a packet is due to its last label. Packets of {@value #PACED_EVENTS} events are due at
 *     intervals of 1 ms, at 1 million events/s, and a packet also waits for the packets before it
 * @param pacedWork the part of that time in which the engine works on the packet
 */
public record PacketTimes(Latency ofOneMs, Latency paced, Latency pacedWork) {
    /** Number of events of a packet, one packet per ms at 1 million events/s. */
    public static final int PACED_EVENTS = 1000;

    private static final long MILLISECOND_US = 1000;
    private static final long MILLISECOND_NS = 1_000_000;
    /** Takes five seconds if the engine keeps up. */
    private static final int MOST_PACED_PACKETS = 5000;

    /** Measures with an engine that has already labelled the events before. */
    static PacketTimes measure(Sofas sofas, EventsInMemory events) {
        Latency ofOneMs = workThrough(sofas, events.packetsOfTime(MILLISECOND_US));
        List<EventBatch> packets = events.packetsOfEvents(PACED_EVENTS).batches();
        packets = packets.subList(0, Math.min(packets.size(), MOST_PACED_PACKETS));
        long[] kept = new long[packets.size()];
        long[] worked = new long[packets.size()];
        pace(sofas, packets, kept, worked);
        return new PacketTimes(ofOneMs, Latency.of(kept), Latency.of(worked));
    }

    private static Latency workThrough(Sofas sofas, EventsInMemory packets) {
        FlowOutput flow = new FlowOutput(packets.largestBatch());
        long[] worked = new long[packets.batches().size()];
        sofas.reset();
        Memory.collect();
        for (int i = 0; i < worked.length; i++) {
            EventBatch packet = packets.batches().get(i);
            long start = System.nanoTime();
            sofas.process(packet, flow);
            worked[i] = System.nanoTime() - start;
        }
        return Latency.of(worked);
    }

    /** Offers packets at a steady pace, whether or not the engine keeps up. */
    private static void pace(Sofas sofas, List<EventBatch> packets, long[] keptNs, long[] workedNs) {
        FlowOutput flow = new FlowOutput(PACED_EVENTS);
        sofas.reset();
        Memory.collect();
        long due = System.nanoTime();
        for (int i = 0; i < keptNs.length; i++) {
            long start = System.nanoTime();
            while (start - due < 0) {
                Thread.onSpinWait();
                start = System.nanoTime();
            }
            sofas.process(packets.get(i), flow);
            long end = System.nanoTime();
            keptNs[i] = end - due;
            workedNs[i] = end - start;
            due += MILLISECOND_NS;
        }
    }
}
