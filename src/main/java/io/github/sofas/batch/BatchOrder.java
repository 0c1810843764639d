package io.github.sofas.batch;

import java.io.Serializable;
import java.util.List;

/**
 * What is done with every recording of a batch.
 *
 * @param options as the command {@code run} takes them, without recording and folder
 * @param resumes whether complete results of the same are left as they are
 * @param out place of the folder of the results
 * @param events place of the folder of the data set of all events; null where none is made
 * @param staging place of a folder, of this batch alone, for what is not whole yet
 */
public record BatchOrder(List<String> options, boolean resumes, String out, String events, String staging)
        implements Serializable {
}
