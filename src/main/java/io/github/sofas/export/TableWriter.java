package io.github.sofas.export;

import java.io.Closeable;
import java.io.IOException;

/** Writes a table to a file, some rows at a time; memory does not grow with it. */
interface TableWriter extends Closeable {
    /**
     * Writes rows.
     *
     * @throws IOException where they cannot be written
     */
    void write(TableRows rows) throws IOException;

    /** Writes what is still held and closes the file. */
    @Override
    void close() throws IOException;
}
