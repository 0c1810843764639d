package io.github.sofas.batch;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;

/**
 * The machines that batches run on. The program finds its input and hands over the tasks through this interface, and
 * knows nothing else of the cluster.
 */
public interface Cluster extends AutoCloseable {
    /**
     * {@return the absolute path of a place on this machine, or the URI of a place elsewhere}
     *
     * @param place the place as the user names it
     * @throws IOException if the text is not a place
     */
    String qualified(String place) throws IOException;

    /**
     * {@return the files that a place or a pattern outside this machine names} These are the file itself, the files of
     * a folder without its subfolders, or the files that match the pattern. Hidden files are left out. Empty if there
     * are none.
     *
     * @param pattern a place, or a pattern with {@code *}, {@code ?}, {@code [abc]} and <code>{a,b}</code>
     * @throws IOException if the place cannot be read
     */
    List<StoredFile> find(String pattern) throws IOException;

    /** {@return the files that are not on this machine} */
    Storage storage();

    /**
     * Starts the cluster. Called once, before the methods below.
     *
     * @param master address of the cluster's master, in the cluster's own syntax; null for the master in its settings
     * @return a description of the cluster for the user
     * @throws IOException if the cluster does not start
     */
    String start(String master) throws IOException;

    /**
     * Labels recordings by {@link BatchProgram#label}, on whatever machine has room.
     *
     * @param order what to do with each recording
     * @param tasks the recordings, in the order in which to begin them
     * @param ended receives the row of each recording as soon as its task has ended
     * @throws IOException if the cluster gave up; finished results remain
     */
    void label(BatchOrder order, List<BatchTask> tasks, Consumer<BatchRow> ended) throws IOException;

    /**
     * Writes rows as a Parquet file on this machine.
     *
     * @param rows the rows, in the order of the table
     * @param file the file, which does not exist yet
     * @throws IOException if the file cannot be written
     */
    void writeTable(List<BatchRow> rows, Path file) throws IOException;

    /** Stops the cluster and releases what {@link #start} took. */
    @Override
    void close();
}
