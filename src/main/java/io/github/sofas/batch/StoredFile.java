package io.github.sofas.batch;

import java.io.Serializable;

/**
 * A file that a batch reads.
 *
 * @param place its absolute path, or its URI where it is not on a disk of this machine
 * @param shownAs as results name it
 * @param bytes its size
 * @param changedMs when it was changed, in ms since 1970
 */
public record StoredFile(String place, String shownAs, long bytes, long changedMs) implements Serializable {
    /** {@return what follows the last slash of a place} */
    public String name() {
        return place.substring(place.lastIndexOf('/') + 1);
    }
}
