package io.github.sofas.batch;

import java.util.List;

/**
 * The program as a cluster calls it: submits a batch on the user's machine, and labels one recording on any machine of
 * the cluster. Found by {@link java.util.ServiceLoader}.
 */
public interface BatchProgram {
    /**
     * Runs the command {@code batch}.
     *
     * @param arguments arguments without the command's name
     * @param cluster labels the recordings of the batch
     * @return the exit code
     */
    int submit(List<String> arguments, Cluster cluster);

    /**
     * Labels one recording. The row reports any fault of the recording or of the disk.
     *
     * @param order what to do
     * @param task the recording to do it with
     * @param storage the files that are not on this machine
     * @return the outcome
     * @throws InterruptedException if the thread was interrupted in order to stop
     */
    BatchRow label(BatchOrder order, BatchTask task, Storage storage) throws InterruptedException;
}
