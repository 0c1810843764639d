/**
 * Batches on Apache Spark. Open {@link io.github.sofas.spark.SparkBatch} first: it is what {@code spark-submit} starts.
 * {@link io.github.sofas.spark.SparkCluster} makes one task of each recording, {@link io.github.sofas.spark.LabelTask}
 * is what an executor does with it: it calls the program, which is kept apart from Spark's libraries ({@link
 * io.github.sofas.spark.IsolatedProgram}).
 */
package io.github.sofas.spark;
