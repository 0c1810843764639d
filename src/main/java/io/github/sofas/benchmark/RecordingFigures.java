package io.github.sofas.benchmark;

import java.util.Map;

/**
 * What was measured with one recording.
 *
 * @param recording its name
 * @param format of its file
 * @param engine labelling alone, events in memory
 * @param helped the same with a helper in a thread of its own; its time on the CPU is that of the other thread
 * @param decode reading and decoding alone
 * @param csv making the rows alone, written nowhere
 * @param run from file to file
 * @param shares of the time of whole runs by stage, 0 to 1, together 1; empty where the virtual machine shows nothing
 * @param figures what else was seen of the engine
 * @param peakHeapBytes most heap in use during the whole runs, which keep no events
 */
public record RecordingFigures(String recording, String format, Rates engine, Rates helped, Rates decode, Rates csv,
                               Rates run, Map<Stage, Double> shares, EngineFigures figures, long peakHeapBytes) {
}
