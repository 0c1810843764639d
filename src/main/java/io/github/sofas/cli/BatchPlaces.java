package io.github.sofas.cli;

import io.github.sofas.batch.Storage;
import java.util.regex.Pattern;

/**
 * The files of a batch, wherever they are.
 *
 * @param remote those that are not on this machine
 */
record BatchPlaces(Storage remote) {
    /** More than one letter, which would be a drive. */
    private static final Pattern URI = Pattern.compile("[A-Za-z][A-Za-z0-9+.-]+:/.*", Pattern.DOTALL);
    private static final Storage LOCAL = new LocalStorage();
    /** What Hive and Spark do not take in the name of a partition's folder as it is. */
    private static final String ESCAPED = "\"#%'*/:=?\\{}[]^\u007f";

    /** Whether a place is not on this machine. */
    static boolean isRemote(String place) {
        return URI.matcher(place).matches();
    }

    /** Where a place's files are. */
    Storage at(String place) {
        return isRemote(place) ? remote : LOCAL;
    }

    /** A file in a folder. */
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
