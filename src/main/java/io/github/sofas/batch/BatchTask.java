package io.github.sofas.batch;

import java.io.Serializable;

/**
 * One recording of a batch, which a cluster labels as one task.
 *
 * @param name name of the results
 * @param recording the file to read
 */
public record BatchTask(String name, StoredFile recording) implements Serializable {
}
