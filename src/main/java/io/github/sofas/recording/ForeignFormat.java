package io.github.sofas.recording;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;

/**
 * A format of events or films that is not read here. Each is recognised and named in the error message, with the way to
 * convert it.
 *
 * @param name name of the format
 * @param magic bytes that identify it
 * @param at place of these bytes in the file
 * @param remedy program or way to convert it
 */
record ForeignFormat(String name, byte[] magic, int at, String remedy) {
    private static final String ROS = "in Python, rosbags (PyPI) reads it and h5py saves its events as HDF5";
    private static final String FILM = "v2e makes events of films";

    private static final List<ForeignFormat> ALL = List.of(
            new ForeignFormat("a ROS 1 bag", "#ROSBAG", 0, "jAER reads it and saves AEDAT; " + ROS),
            new ForeignFormat("an MCAP file", "\u0089MCAP", 0, ROS),
            new ForeignFormat("an SQLite database, such as a ROS 2 bag", "SQLite format 3", 0, ROS),
            new ForeignFormat("an AVI film", "AVI ", 8, FILM),
            new ForeignFormat("an MP4 film", "ftyp", 4, FILM),
            new ForeignFormat("a zip archive, such as NumPy's npz", "PK\u0003\u0004", 0,
                    "unpack it; arrays are read as HDF5 (h5py) or CSV (pandas)"),
            new ForeignFormat("a NumPy array", "\u0093NUMPY", 0, "save it as HDF5 (h5py) or CSV (pandas, savetxt)"),
            new ForeignFormat("packed by gzip", "\u001f\u008b", 0, "unpack it: gunzip"),
            new ForeignFormat("a 7z archive", "7z\u00bc\u00af", 0, "unpack it: 7z x"),
            new ForeignFormat("packed by xz", "\u00fd7zXZ", 0, "unpack it: unxz"),
            new ForeignFormat("packed by Zstandard", "\u0028\u00b5\u002f\u00fd", 0, "unpack it: unzstd"),
            new ForeignFormat("a Parquet table", "PAR1", 0, "save it as CSV (pandas, DuckDB)"),
            new ForeignFormat("a Matlab file", "MATLAB 5.0", 0, "save its events as CSV, or by save -v7.3 as HDF5"));

    private ForeignFormat(String name, String magic, int at, String remedy) {
        this(name, magic.getBytes(StandardCharsets.ISO_8859_1), at, remedy);
    }

    /** The foreign format that begins at a place of a buffer; null where none is known. */
    static ForeignFormat at(byte[] buffer, int position, int limit) {
        for (ForeignFormat format : ALL) {
            int from = position + format.at;
            int to = from + format.magic.length;
            if (to <= limit && Arrays.equals(buffer, from, to, format.magic, 0, format.magic.length)) {
                return format;
            }
        }
        return null;
    }
}
