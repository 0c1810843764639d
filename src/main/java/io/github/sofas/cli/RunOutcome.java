package io.github.sofas.cli;

import io.github.sofas.event.EventSourceException;
import io.github.sofas.export.RunSummary;

/**
 * The outcome of a run.
 *
 * @param summary as written
 * @param damage why the events could not be read to their end; null if they could
 * @param reportFailure why there is no report; null if there is one or none was asked for
 */
record RunOutcome(RunSummary summary, EventSourceException damage, Exception reportFailure) {
}
