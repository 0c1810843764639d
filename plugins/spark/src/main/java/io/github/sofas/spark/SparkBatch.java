package io.github.sofas.spark;

import java.util.List;

/** Where {@code spark-submit} starts: the command {@code batch} with a cluster to run on. */
public final class SparkBatch {
    private SparkBatch() {
    }

    /**
     * Runs a batch and ends the program with its exit code.
     *
     * @param arguments as of {@code ./sofas batch}
     */
    public static void main(String[] arguments) {
        System.exit(IsolatedProgram.get().submit(List.of(arguments), new SparkCluster()));
    }
}
