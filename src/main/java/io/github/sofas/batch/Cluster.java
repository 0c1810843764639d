package io.github.sofas.batch;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;

/** What batches run on. */
public interface Cluster extends AutoCloseable {
    /**
     * {@return the absolute path of a place on this machine, or its URI where it is not}
     *
     * @param place as the user names it
     * @throws IOException where it is no place
     */
    String qualified(String place) throws IOException;

    /**
     * {@return the files that a place or a pattern names which is not on this machine} Those are the file, the files of
     * a folder (not of those inside it), or those that match, hidden ones left out; none where there is none.
     *
     * @param pattern may have {@code *}, {@code ?}, {@code [abc]} and <code>{a,b}</code>
     * @throws IOException where it cannot be looked at
     */
    List<StoredFile> find(String pattern) throws IOException;

    /** {@return the files that are not on this machine} */
    Storage storage();

    /**
     * Takes what it needs to run; called once, before what follows.
     *
     * @param master who gives it, in the cluster's own words; null for whom the cluster's settings name
     * @return what the user is told of it
     * @throws IOException where it cannot be had
     */
    String start(String master) throws IOException;

    /**
     * Labels recordings, by {@link BatchProgram#label} wherever there is room.
     *
     * @param order what is done with each
     * @param tasks in the order in which they are begun
     * @param ended gets the row of each as soon as it is there
     * @throws IOException where the cluster gave up; what is done is done
     */
    void label(BatchOrder order, List<BatchTask> tasks, Consumer<BatchRow> ended) throws IOException;

    /**
     * Writes the rows as a Parquet file of this machine.
     *
     * @param rows in their order
     * @param file that is not there
     * @throws IOException where it cannot be written
     */
    void writeTable(List<BatchRow> rows, Path file) throws IOException;

    /** Gives back what it took. */
    @Override
    void close();
}
