/**
 * The command line, one class per command. Open {@link io.github.sofas.cli.RunCommand} first: it checks its arguments,
 * then hands each recording to a {@code RecordingRun}, the loop from reader through engine to files. On a cluster,
 * {@link io.github.sofas.cli.BatchCommand} does the same.
 */
package io.github.sofas.cli;
