package io.github.sofas.cli;

import io.github.sofas.batch.Storage;
import java.util.regex.Pattern;

/**
 * Finds the storage of a batch's files by their places: paths of this machine, or URIs.
 *
 * @param remote storage of the files that are not on this machine
 */
record BatchPlaces(Storage remote) {
    /** A scheme of more than one letter; a single letter would be a drive. */
    private static final Pattern URI = Pattern.compile("[A-Za-z][A-Za-z0-9+.-]+:/.*", Pattern.DOTALL);
    private static final Storage LOCAL = new LocalStorage();
    /** Characters that Hive and Spark do not accept unescaped in the name of a partition's folder. */
    private static final String ESCAPED = "\"#%'*/:=?\\{}[]^\u007f";

    /** Whether a place is not on this machine. */
    static boolean isRemote(String place) {
        return URI.matcher(place).matches();
    }

    /** The storage of the file at a place. */
    Storage at(String place) {
        return isRemote(place) ? remote : LOCAL;
    }

    /** The place of a file in a folder. */
    static String in(String folder, String name) {
        return folder.endsWith("/") ? folder + name : folder + "/" + name;
    }

    /** The folder of a data set that holds the rows of one recording. */
    static String partition(String dataSet, String recordingName) {
        StringBuilder folder = new StringBuilder("recording=");
        for (char c : recordingName.toCharArray()) {
            if (c < ' ' || ESCAPED.indexOf(c) >= 0) {
                folder.append(String.format("%%%02X", (int) c));
            } else {
                folder.append(c);
            }
        }
        return in(dataSet, folder.toString());
    }
}
