package io.github.sofas.recording;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.util.List;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

public class NMnistReaderTest {
    @Rule public final TemporaryFolder folder = new TemporaryFolder();

    private ReadResult read(String chip, int... bytes) throws IOException {
        byte[] file = new byte[bytes.length];
        for (int i = 0; i < bytes.length; i++) {
            file[i] = (byte) bytes[i];
        }
        return ReadResult.of(folder.getRoot().toPath(), "a.bin", file, ReadResult.PLAIN.withChip(chip));
    }

    /** The first two events of a file of N-MNIST: 0x80028E is ON at 654 us, 0x12000B is 1179659 us. */
    @Test public void readsEventsOfFiveBytes() throws Exception {
        ReadResult read = read("34x34", 7, 15, 0x80, 0x02, 0x8E, 19, 18, 0x12, 0, 0x0B);
        assertEquals(List.of("654 7 15 1", "1179659 19 18 -1"), read.events);
        assertEquals(List.of(), read.faults);
    }

    /** Row 240 is no event but 2^13 us more for all that follow. */
    @Test public void addsOverflowsOfTime() throws Exception {
        ReadResult read = read("34x34", 1, 1, 0, 0, 5, 0, 240, 0, 0, 0, 1, 1, 0, 0, 6);
        assertEquals(List.of("5 1 1 -1", "8198 1 1 -1"), read.events);
        assertEquals(1, read.counts.timeWraps());
    }

    @Test public void reportsWhatIsOutsideAndWhatIsCutOff() throws Exception {
        ReadResult read = read("34x34", 34, 0, 0, 0, 0, 1, 2, 0, 0, 7, 9, 9);
        assertEquals(List.of("7 1 2 -1"), read.events);
        assertEquals(List.of("[a.bin] event 0 at byte 0: x must be smaller than width 34 but was 34"), read.faults);
        assertEquals("[a.bin] event 2 at byte 10: truncated, an event must have 5 bytes but had 2", read.error);
    }

    @Test public void asksForTheSize() throws Exception {
        String error = read(null, 1, 1, 0, 0, 5).error;
        assertTrue(error, error.startsWith("[a.bin] the recording names no chip: --chip must name one of "));
    }
}
