package io.github.sofas.recording;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;

/**
 * Collects the faults of a recording that do not end its reading: for each kind, the message of the first fault and
 * their number.
 */
final class Faults {
    private final Map<String, Fault> faults = new LinkedHashMap<>();

    private static final class Fault {
        private final String first;
        private long count = 1;

        Fault(String first) {
            this.first = first;
        }
    }

    /** Adds a fault. Faults are counted by kind; the message is made only for the first fault of a kind. */
    void add(String kind, Supplier<String> message) {
        Fault fault = faults.get(kind);
        if (fault == null) {
            faults.put(kind, new Fault(message.get()));
        } else {
            fault.count++;
        }
    }

    /** One line per kind, in the order in which the kinds were met. */
    List<String> lines() {
        List<String> lines = new ArrayList<>();
        for (Fault fault : faults.values()) {
            lines.add(fault.count == 1 ? fault.first : fault.first + " (the first of " + fault.count + ")");
        }
        return List.copyOf(lines);
    }
}
