package io.github.sofas.export;

import java.io.Closeable;
import java.io.IOException;

/** Writes a table to a file, some rows at a time. Memory does not grow with the table. */
interface TableWriter extends Closeable {
    /**
     * Writes rows.
     *
     * @throws IOException if they cannot be written
     */
    void write(TableRows rows) throws IOException;

    /** Writes the rows that are still held and closes the file. */
    @Override
    void close() throws IOException;
}
