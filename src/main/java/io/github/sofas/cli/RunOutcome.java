package io.github.sofas.cli;

import io.github.sofas.event.EventSourceException;
import io.github.sofas.export.RunSummary;

/**
 * What came of a run.
 *
 * @param summary as written
 * @param damage why the events could not be had to their end; null where they could
 * @param reportFailure why there is no report; null where there is, or none was asked for
 */
record RunOutcome(RunSummary summary, EventSourceException damage, Exception reportFailure) {
}
