package io.github.sofas.cli;

import io.github.sofas.flow.Labelling;

/**
 * Labelling of one recording, until it is closed.
 *
 * @param labelling for the recording's sensor
 * @param end ends the threads that it has of its own
 */
record OpenLabelling(Labelling labelling, Runnable end) implements AutoCloseable {
    /** Labelling in the thread that asks. */
    OpenLabelling(Labelling labelling) {
        this(labelling, () -> { });
    }

    @Override
    public void close() {
        end.run();
    }
}
