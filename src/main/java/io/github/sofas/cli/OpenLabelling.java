package io.github.sofas.cli;

import io.github.sofas.flow.Labelling;

/**
 * The labelling of one recording; closing it ends the threads of the labelling.
 *
 * @param labelling made for the recording's sensor
 * @param end ends the labelling's own threads
 */
record OpenLabelling(Labelling labelling, Runnable end) implements AutoCloseable {
    /** A labelling in the caller's thread, with nothing to end. */
    OpenLabelling(Labelling labelling) {
        this(labelling, () -> { });
    }

    @Override
    public void close() {
        end.run();
    }
}
