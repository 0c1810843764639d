package io.github.sofas.benchmark;

import java.util.Map;

/**
 * Figures that a {@link Benchmark} measures with one recording.
 *
 * @param recording name of the recording
 * @param format format of the recording's file
 * @param engine rates of labelling alone, with the events in memory
 * @param helped rates of labelling with a helper in a thread of its own; the CPU time is that of the labelling thread
 * @param decode rates of reading and decoding alone
 * @param csv rates of making the CSV rows alone, which are written nowhere
 * @param run rates of the whole run from file to file
 * @param shares share of each stage in the time of whole runs, 0 to 1, 1 in total; empty if no stack was sampled
 * @param figures further figures of the engine
 * @param peakHeapBytes peak of the heap in use during the whole runs, which keep no events in memory
 */
public record RecordingFigures(String recording, String format, Rates engine, Rates helped, Rates decode, Rates csv,
                               Rates run, Map<Stage, Double> shares, EngineFigures figures, long peakHeapBytes) {
}
