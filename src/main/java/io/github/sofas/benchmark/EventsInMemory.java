package io.github.sofas.benchmark;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.EventSource;
import io.github.sofas.event.EventSourceException;
import io.github.sofas.event.SensorSize;
import java.util.ArrayList;
import java.util.List;

/**
 * All events of a recording in memory, cut into batches, so that the engine can be timed without reading files.
 *
 * @param sensor size of the sensor that the events come from
 * @param batches batches in order of time, none of them empty
 * @param size number of events in all batches
 */
record EventsInMemory(SensorSize sensor, List<EventBatch> batches, long size) {

    /** Decides whether a batch ends before the next event. */
    @FunctionalInterface
    private interface Cut {
        boolean between(EventBatch batch, int size, long nextTimeUs);
    }

    /** Reads a source to its end. */
    static EventsInMemory read(EventSource source, int batchSize) throws EventSourceException {
        List<EventBatch> batches = new ArrayList<>();
        EventBatch batch = new EventBatch(batchSize);
        long size = 0;
        while (source.next(batch)) {
            batches.add(part(batch, 0, batch.size()));
            size += batch.size();
        }
        return new EventsInMemory(source.sensor(), batches, size);
    }

    private static EventBatch part(EventBatch from, int start, int size) {
        EventBatch part = new EventBatch(size);
        part.addAll(from, start, size);
        return part;
    }

    /** Returns the same events in packets as a camera sends them: one for each period of {@code us} with events. */
    EventsInMemory packetsOfTime(long us) {
        return cut((packet, count, nextUs) -> Math.floorDiv(nextUs, us) != Math.floorDiv(packet.timeUs[0], us));
    }

    /** Returns the same events in packets of the given number of events; the last packet may hold fewer. */
    EventsInMemory packetsOfEvents(int events) {
        return cut((packet, count, nextTimeUs) -> count == events);
    }

    private EventsInMemory cut(Cut cut) {
        List<EventBatch> packets = new ArrayList<>();
        EventBatch open = new EventBatch(1024);
        for (EventBatch batch : batches) {
            for (int i = 0; i < batch.size(); i++) {
                int count = open.size();
                if (count > 0 && cut.between(open, count, batch.timeUs[i])) {
                    packets.add(part(open, 0, count));
                    open.clear();
                }
                if (open.isFull()) {
                    EventBatch larger = new EventBatch(2 * open.capacity());
                    larger.addAll(open, 0, count);
                    open = larger;
                }
                open.add(batch.timeUs[i], batch.x[i], batch.y[i], batch.polarity[i]);
            }
        }
        if (open.size() > 0) {
            packets.add(part(open, 0, open.size()));
        }
        return new EventsInMemory(sensor, packets, size);
    }

    /** Time from the first event to the last, in µs. */
    long durationUs() {
        if (batches.isEmpty()) {
            return 0;
        }
        EventBatch last = batches.get(batches.size() - 1);
        return last.timeUs[last.size() - 1] - batches.get(0).timeUs[0];
    }

    /** The size of the largest batch; 1 if there is no batch. */
    int largestBatch() {
        return batches.stream().mapToInt(EventBatch::size).max().orElse(1);
    }
}
