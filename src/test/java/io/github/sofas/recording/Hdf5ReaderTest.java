package io.github.sofas.recording;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import io.jhdf.api.WritableGroup;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

public class Hdf5ReaderTest {
    @Rule public final TemporaryFolder folder = new TemporaryFolder();

    private ReadResult read(byte[] file, String chip) throws IOException {
        return ReadResult.of(folder.getRoot().toPath(), "a.h5", file, ReadResult.PLAIN.withChip(chip));
    }

    @Test public void readsDsecsLayoutPlainAndInChunks() throws Exception {
        List<String> events = List.of("1000000000010 0 0 1", "1000000000012 15 11 -1", "1000000000013 3 4 1",
                "1000000000013 4 5 -1", "1000000000020 5 6 1");
        for (boolean isChunked : new boolean[] {false, true}) {
            ReadResult read = read(Hdf5Bytes.dsec(isChunked), null);
            assertEquals(events, read.events);
            assertEquals(List.of(), read.faults);
            assertNull(read.error);
        }
    }

    /** Seconds as doubles hold 1.5e9 s to 0.24 us. */
    @Test public void readsMvsecsLayout() throws Exception {
        assertEquals(List.of("1506117892000001 0 0 1", "1506117892000003 15 11 -1"),
                read(Hdf5Bytes.mvsec(), "346x260").events);
    }

    @Test public void readsV2esLayoutAndThatOfSimulators() throws Exception {
        byte[] v2e = Hdf5Bytes.of(hdf -> hdf.putDataset("events", new int[][] {{7, 1, 2, 1}, {9, 3, 4, 0}}));
        assertEquals(List.of("7 1 2 1", "9 3 4 -1"), read(v2e, "16x12").events);
        byte[] rpg = Hdf5Bytes.of(hdf -> {
            WritableGroup events = hdf.putGroup("events");
            events.putDataset("xs", new short[] {1, 3});
            events.putDataset("ys", new short[] {2, 4});
            events.putDataset("ps", new byte[] {1, 0});
            events.putDataset("ts", new double[] {0.000007, 0.0000094});
            hdf.putAttribute("sensor_resolution", new int[] {12, 16});
        });
        assertEquals(List.of("7 1 2 1", "9 3 4 -1"), read(rpg, null).events);
    }

    @Test public void asksForTheSensorAndNamesTheUsualOne() throws Exception {
        String error = read(Hdf5Bytes.mvsec(), null).error;
        assertTrue(error, error.startsWith("[a.h5] the recording names no chip: --chip must name one of ")
                && error.endsWith(" or a size such as 240x180; MVSEC's is 346x260; all its events "
                + "lie within 34x34"));
    }

    @Test public void countsAndReportsEventsOutsideTheSensorAndStepsBack() throws Exception {
        byte[] file = Hdf5Bytes.of(hdf -> hdf.putDataset("events",
                new int[][] {{7, 16, 2, 1}, {9, 3, 12, 0}, {8, -1, 1, 1}, {9, 1, 1, 1}, {8, 1, 1, 1}}));
        ReadResult read = read(file, "16x12");
        assertEquals(List.of("9 1 1 1", "9 1 1 1"), read.events);
        assertEquals(3, read.counts.outsideSensor());
        assertEquals(1, read.counts.stepsBack());
        assertEquals("[a.h5] event 0: x must be smaller than width 16 but was 16 (the first of 3)", read.faults.get(0));
    }

    @Test public void namesWhatIsNotThere() throws Exception {
        assertEquals("[a.h5] header at byte 0: unsupported, events must be at events/x y p t (DSEC), davis/left/events "
                + "(MVSEC), CD/events (Prophesee) or events, but none are there",
                read(Hdf5Bytes.of(hdf -> hdf.putGroup("frames")), "16x12").error);
        assertEquals("[a.h5] header at byte 0: malformed, HDF5 must be whole: the group /events/ must have the data "
                + "set x", read(Hdf5Bytes.of(hdf -> hdf.putGroup("events")), "16x12").error);
        byte[] uneven = Hdf5Bytes.of(hdf -> {
            WritableGroup events = hdf.putGroup("events");
            for (String name : List.of("x", "y", "p")) {
                events.putDataset(name, new short[] {1, 2});
            }
            events.putDataset("t", new int[] {1, 2, 3});
        });
        assertEquals("[a.h5] header at byte 0: malformed, HDF5 must be whole: all data sets of the events must have "
                + "one length but have 2 and 3", read(uneven, "16x12").error);
    }

    @Test public void everyCutIsNamed() throws Exception {
        byte[] whole = Hdf5Bytes.dsec(true);
        for (int length = 1; length < whole.length; length += 37) {
            String error = read(Arrays.copyOf(whole, length), null).error;
            assertTrue("cut at " + length + ": " + error, error != null
                    && error.matches("\\[a.h5\\] (header at byte 0|event \\d+): truncated, .*"));
        }
    }
}
