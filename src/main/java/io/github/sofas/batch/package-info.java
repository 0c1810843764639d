/**
 * The interface between the program and a cluster that runs a batch of recordings, in types of the JDK only. Open
 * {@link io.github.sofas.batch.BatchProgram} first: a cluster calls it on the machine where a batch is submitted, and
 * on the machines where recordings are labelled. {@link io.github.sofas.batch.Cluster} is what the program calls in
 * return.
 *
 * <p>Only these types are loaded from one place for both sides. A cluster has libraries of its own, in other versions
 * than the program's; therefore the program is kept in a class loader of its own.
 */
package io.github.sofas.batch;
