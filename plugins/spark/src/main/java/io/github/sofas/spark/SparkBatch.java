package io.github.sofas.spark;

import java.util.List;

/** Main class of {@code spark-submit}: runs the command {@code batch} with a Spark cluster. */
public final class SparkBatch {
    private SparkBatch() {
    }

    /**
     * Runs a batch and ends the process with its exit code.
     *
     * @param arguments arguments of {@code ./sofas batch}
     */
    public static void main(String[] arguments) {
        System.exit(IsolatedProgram.get().submit(List.of(arguments), new SparkCluster()));
    }
}
