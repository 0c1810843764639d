package io.github.sofas.batch;

import java.util.List;

/** The program as a cluster calls it; found by {@link java.util.ServiceLoader}. */
public interface BatchProgram {
    /**
     * Runs the command {@code batch}.
     *
     * @param arguments without the command's name
     * @param cluster where its recordings are labelled
     * @return the exit code
     */
    int submit(List<String> arguments, Cluster cluster);

    /**
     * Labels one recording. Whatever is wrong with it, or with the disk, is in the row.
     *
     * @param order what is done
     * @param task with what
     * @param storage the files that are not on this machine
     * @return what became of it
     * @throws InterruptedException where it was told to stop
     */
    BatchRow label(BatchOrder order, BatchTask task, Storage storage) throws InterruptedException;
}
