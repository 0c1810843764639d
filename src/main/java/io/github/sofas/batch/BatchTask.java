package io.github.sofas.batch;

import java.io.Serializable;

/**
 * One recording of a batch.
 *
 * @param name of its results
 * @param recording what is read
 */
public record BatchTask(String name, StoredFile recording) implements Serializable {
}
