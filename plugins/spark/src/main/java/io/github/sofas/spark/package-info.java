/**
 * Batches on Apache Spark. Open {@link io.github.sofas.spark.SparkBatch} first: {@code spark-submit} starts this class.
 * {@link io.github.sofas.spark.SparkCluster} makes one task of each recording. {@link io.github.sofas.spark.LabelTask}
 * runs on an executor and calls the program, which {@link io.github.sofas.spark.IsolatedProgram} keeps apart from
 * Spark's libraries.
 */
package io.github.sofas.spark;
