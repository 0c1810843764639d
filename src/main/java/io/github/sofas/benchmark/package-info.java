/**
 * Measurements of speed. Open {@link io.github.sofas.benchmark.Benchmark} first: it measures one recording;
 * {@link io.github.sofas.benchmark.BuiltInScenes} makes recordings if the user names none.
 *
 * <p>Runs the same steps as the command line does, in one thread, on the recording's own bytes.
 */
package io.github.sofas.benchmark;
