package io.github.sofas.jaer;

import java.util.Locale;

/**
 * Counts the filter's events, events with flow, and times since its last reset, for the statistics that the user asks
 * for.
 */
final class Counters {
    private long events;
    private long withFlow;
    private long readNs;
    private long engineNs;

    void add(LabelledPacket packet) {
        events += packet.batch().size();
        for (int i = 0; i < packet.batch().size(); i++) {
            withFlow += packet.flow().segment[i] == 0 ? 0 : 1;
        }
        readNs += packet.readNs();
        engineNs += packet.engineNs();
    }

    void reset() {
        events = 0;
        withFlow = 0;
        readNs = 0;
        engineNs = 0;
    }

    long engineNs() {
        return engineNs;
    }

    /** The statistics in one line. */
    String text() {
        return String.format(Locale.ROOT, "%,d events, %.1f %% with flow, %,.0f events/s labelled, %.1f %% on top for "
            + "reading packets", events, 100.0 * withFlow / Math.max(1, events), events * 1e9 / Math.max(1, engineNs),
            100.0 * readNs / Math.max(1, engineNs));
    }
}
