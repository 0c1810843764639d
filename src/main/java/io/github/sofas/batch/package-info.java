/**
 * What the program and a cluster say to each other about a batch of recordings, in types of the JDK only. Open {@link
 * io.github.sofas.batch.BatchProgram} first: it is what a cluster calls, on the machine where a batch is submitted and
 * on those where recordings are labelled; {@link io.github.sofas.batch.Cluster} is what it calls back.
 *
 * <p>These types are the only ones that both sides load from one place: a cluster has libraries of its own, in other
 * versions than the program's, so that the program is kept in a class loader by itself.
 */
package io.github.sofas.batch;
