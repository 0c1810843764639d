/**
 * The command line, one class a command. Open {@link io.github.sofas.cli.RunCommand} first: it checks what was asked,
 * then hands each recording to a {@code RecordingRun}, the loop from reader through engine to files.
 */
package io.github.sofas.cli;
