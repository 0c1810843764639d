/**
 * Measurements of speed. Start with {@link io.github.sofas.benchmark.Benchmark}, which measures one recording.
 * {@link io.github.sofas.benchmark.BuiltInScenes} makes recordings if the user names none.
 *
 * <p>A benchmark runs the same steps as the command line, in one thread, on the bytes of the recording itself.
 */
package io.github.sofas.benchmark;
