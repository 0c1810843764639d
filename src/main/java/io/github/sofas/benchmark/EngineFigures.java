package io.github.sofas.benchmark;

import io.github.sofas.event.SensorSize;

/**
 * What else was seen of the engine.
 *
 * @param sensor that the events come from
 * @param shareWithFlow events with flow among all, 0 to 1
 * @param eventsPerPx density: events with flow while what they show travels by a pixel; 0 where nothing has flow
 * @param allocatedBytesPerEvent what labelling an event allocates, in an engine that has labelled the recording before
 * @param heldBytes what the engine keeps of the heap after the recording
 * @param packets how long it keeps packets
 */
public record EngineFigures(SensorSize sensor, double shareWithFlow, double eventsPerPx, double allocatedBytesPerEvent,
                            long heldBytes, PacketTimes packets) {
}
