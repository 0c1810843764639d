package io.github.sofas.recording;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** What is not read is named, with what converts it. */
public class ForeignFormatTest {
    @Rule public final TemporaryFolder folder = new TemporaryFolder();

    private String error(String name, String bytes) throws IOException {
        return ReadResult.of(folder.getRoot().toPath(), name, bytes.getBytes(StandardCharsets.ISO_8859_1),
                ReadResult.PLAIN.withChip("DVS128")).error;
    }

    @Test public void namesTheFormatAndAConverterWhateverTheExtension() throws Exception {
        Map<String, String> starts = Map.of("#ROSBAG V2.0\n", "a ROS 1 bag; ", "\u0089MCAP0\r\n", "an MCAP file; ",
                "SQLite format 3\0", "an SQLite database, such as a ROS 2 bag; ",
                "RIFF\1\2\3\4AVI LIST", "an AVI film; ",
                "PK\3\4abc", "a zip archive, such as NumPy's npz; ", "\0\0\0\40ftypisom", "an MP4 film; ",
                "\u0093NUMPY\1\0", "a NumPy array; ", "PAR1abcd", "a Parquet table; ");
        for (Map.Entry<String, String> each : starts.entrySet()) {
            for (String name : new String[] {"a.bag", "a.dat", "a.txt", "a.bin", "a"}) {
                String error = error(name, each.getKey() + "........");
                assertTrue(error, error.startsWith("[" + name + "] header at byte 0: unsupported, it is "
                        + each.getValue()));
            }
        }
        assertEquals("[a.bag] header at byte 0: unsupported, it is a ROS 1 bag; jAER reads it and saves AEDAT; in "
                + "Python, rosbags (PyPI) reads it and h5py saves its events as HDF5",
                error("a.bag", "#ROSBAG V2.0\n"));
    }
}
