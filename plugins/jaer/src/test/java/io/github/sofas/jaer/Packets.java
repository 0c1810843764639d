package io.github.sofas.jaer;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import io.github.sofas.simulate.Scene;
import io.github.sofas.simulate.SimulatedRecording;
import io.github.sofas.simulate.SimulationOptions;
import java.util.ArrayList;
import java.util.List;
import net.sf.jaer.event.ApsDvsEvent;
import net.sf.jaer.event.ApsDvsEventPacket;
import net.sf.jaer.event.BasicEvent;
import net.sf.jaer.event.EventPacket;
import net.sf.jaer.event.PolarityEvent;

/** Packets of jAER for tests: y up. */
final class Packets {
    static final SensorSize SENSOR = new SensorSize(128, 128);

    private Packets() {
    }

    static PolarityEvent event(int timestamp, int x, int y, PolarityEvent.Polarity polarity) {
        return fill(new PolarityEvent(), timestamp, x, y, polarity);
    }

    private static <E extends PolarityEvent> E fill(E event, int timestamp, int x, int y,
                                                    PolarityEvent.Polarity polarity) {
        event.timestamp = timestamp;
        event.x = (short) x;
        event.y = (short) y;
        event.polarity = polarity;
        return event;
    }

    static EventPacket<BasicEvent> of(BasicEvent... events) {
        EventPacket<BasicEvent> packet = new EventPacket<>();
        packet.events.addAll(List.of(events));
        return packet;
    }

    /** An event, an IMU sample, a frame's pixel, an event. */
    static ApsDvsEventPacket<ApsDvsEvent> mixed() {
        ApsDvsEventPacket<ApsDvsEvent> packet = new ApsDvsEventPacket<>();
        for (int i = 0; i < 4; i++) {
            ApsDvsEvent event = fill(new ApsDvsEvent(), 10 + i, 3, 4, PolarityEvent.Polarity.On);
            event.imuSample = i == 1;
            event.apsData = i == 2;
            packet.events.add(event);
        }
        return packet;
    }

    /** Two objects that pass each other, in batches and in packets of 500 events. */
    static List<EventBatch> film() {
        SimulatedRecording film = SimulatedRecording.of(Scene.TWO_OPPOSITE,
            SimulationOptions.defaults().withSensor(SENSOR).withScale(0.5).withDirectionDeg(20));
        List<EventBatch> batches = new ArrayList<>();
        for (int i = 0; i < Math.min(12_000, film.size()); i++) {
            if (i % 500 == 0) {
                batches.add(new EventBatch(500));
            }
            batches.get(i / 500).add(film.timeUs[i], film.x[i], film.y[i], film.polarity[i]);
        }
        return batches;
    }

    static EventPacket<BasicEvent> of(EventBatch batch) {
        EventPacket<BasicEvent> packet = new EventPacket<>();
        for (int i = 0; i < batch.size(); i++) {
            packet.events.add(event((int) batch.timeUs[i], batch.x[i], SENSOR.height() - 1 - batch.y[i],
                batch.polarity[i] > 0 ? PolarityEvent.Polarity.On : PolarityEvent.Polarity.Off));
        }
        return packet;
    }
}
