/**
 * How fast everything is. Open {@link io.github.sofas.benchmark.Benchmark} first: it measures one recording from every
 * side; {@link io.github.sofas.benchmark.BuiltInScenes} makes recordings where the user names none.
 *
 * <p>Runs the same steps as the command line does, in one thread, on the recording's own bytes.
 */
package io.github.sofas.benchmark;
