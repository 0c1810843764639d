package io.github.sofas.batch;

import java.io.Serializable;

/**
 * A file that a batch reads, with size and time of change as they were when the file was found.
 *
 * @param place absolute path of the file, or its URI if the file is not on a disk of this machine
 * @param shownAs name of the file in the results
 * @param bytes size of the file
 * @param changedMs time of the file's last change, in ms since 1970
 */
public record StoredFile(String place, String shownAs, long bytes, long changedMs) implements Serializable {
    /** {@return the name of the file: the part of its place after the last slash} */
    public String name() {
        return place.substring(place.lastIndexOf('/') + 1);
    }
}
