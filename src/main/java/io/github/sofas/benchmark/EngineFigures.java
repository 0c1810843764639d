package io.github.sofas.benchmark;

import io.github.sofas.event.SensorSize;

/**
 * Figures of the engine beside its rate.
 *
 * @param sensor size of the sensor that the events come from
 * @param shareWithFlow share of the events that have flow, 0 to 1
 * @param eventsPerPx density: events with flow per pixel of travel at their mean speed; 0 if no event has flow
 * @param allocatedBytesPerEvent bytes allocated per event by an engine that has labelled the recording before
 * @param heldBytes bytes of the heap that the engine holds after the recording
 * @param packets how long the engine takes for packets
 */
public record EngineFigures(SensorSize sensor, double shareWithFlow, double eventsPerPx, double allocatedBytesPerEvent,
                            long heldBytes, PacketTimes packets) {
}
