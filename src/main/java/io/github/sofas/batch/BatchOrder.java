package io.github.sofas.batch;

import java.io.Serializable;
import java.util.List;

/**
 * The order for a batch: what every task does with its recording. Serializable, because a cluster sends it to the
 * machines where recordings are labelled.
 *
 * @param options options as the command {@code run} takes them, without recording and folder
 * @param resumes whether complete results of an equal run are left as they are
 * @param out place of the folder of the results
 * @param events place of the folder of the data set of all events; null if none is made
 * @param staging place of a folder for unfinished files, used by this batch alone
 */
public record BatchOrder(List<String> options, boolean resumes, String out, String events, String staging)
        implements Serializable {
}
