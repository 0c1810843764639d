package io.github.sofas.cli;

import io.github.sofas.event.EventSourceException;
import io.github.sofas.export.RecordingSummary;
import io.github.sofas.export.ResultFiles;
import io.github.sofas.export.RunSummary;
import io.github.sofas.export.SegmentsCsv;
import io.github.sofas.recording.RecordingCounts;
import io.github.sofas.recording.RecordingReader;
import java.io.IOException;
import java.io.OutputStream;
import java.lang.management.ManagementFactory;
import java.lang.management.MemoryPoolMXBean;
import java.lang.management.MemoryType;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Sums up a run: translates the counts of a reader into the words of the results, and writes the files that come last.
 */
final class Summaries {
    private Summaries() {
    }

    /**
     * Sums up a recording that was read as far as possible.
     *
     * @param recording name of the recording in the summary
     * @param damage why it could not be read to its end; null if it was
     */
    static RecordingSummary of(String recording, RecordingReader reader, EventSourceException damage) {
        return of(recording, reader, damage, List.of());
    }

    /** The same with notes in addition to the reader's own. */
    static RecordingSummary of(String recording, RecordingReader reader, EventSourceException damage,
                               List<String> notes) {
        List<String> allNotes = new ArrayList<>(notes);
        allNotes.addAll(reader.notes());
        RecordingCounts counts = reader.counts();
        Map<String, Long> byType = new LinkedHashMap<>();
        byType.put("dvs_events", counts.events());
        byType.put("aps_samples", counts.apsSamples());
        byType.put("frames", counts.frames());
        byType.put("imu_samples", counts.imuSamples());
        byType.put("triggers", counts.triggers());
        byType.put("invalid", counts.invalid());
        byType.put("outside_sensor", counts.outsideSensor());
        byType.put("steps_back_in_time", counts.stepsBack());
        byType.put("time_wraps", counts.timeWraps());
        byType.put("other_records", counts.otherRecords());
        byType.put("malformed", counts.malformed());
        byType.put("damaged_times", counts.damagedTimes());
        byType.put("time_restarts", counts.timeRestarts());
        List<String> faults = new ArrayList<>(reader.faults());
        if (damage != null) {
            faults.add(damage.getMessage());
        }
        String format = reader.formatName() + reader.compression().map(how -> " (" + how + ")").orElse("");
        return new RecordingSummary(recording, format, reader.chip().orElse(""), reader.sensor(),
            counts.events(), reader.firstTimeUs(), reader.lastTimeUs(), byType, damage == null, faults,
            allNotes, counts.doubtfulShare());
    }

    /** Number of DVS events that were in the file but not delivered, by reason. */
    static Map<String, Long> dropped(RecordingCounts counts) {
        Map<String, Long> dropped = new LinkedHashMap<>();
        dropped.put("invalid", counts.invalid());
        dropped.put("outside_sensor", counts.outsideSensor());
        dropped.put("damaged_times", counts.damagedTimes());
        return dropped;
    }

    /**
     * Peak use of the heap, summed over its parts. The sum is at least the true peak: the parts need not have peaked
     * together.
     */
    static long peakHeapBytes() {
        long peak = 0;
        for (MemoryPoolMXBean pool : ManagementFactory.getMemoryPoolMXBeans()) {
            if (pool.getType() == MemoryType.HEAP) {
                peak += pool.getPeakUsage().getUsed();
            }
        }
        return peak;
    }

    /**
     * Writes the results that are known only at the end. The summary comes last: its presence shows that the others are
     * complete.
     *
     * @throws IOException if they cannot be written
     */
    static void write(RunSummary summary, ResultFiles results, ResultNames names) throws IOException {
        try (OutputStream file = results.create(names.segments())) {
            SegmentsCsv.write(file, summary.segments());
        }
        Map<String, Long> bytes = results.bytes();
        try (OutputStream file = results.create(names.summary())) {
            summary.write(file, bytes);
        }
    }
}
