package io.github.sofas.recording;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

public class TextReaderTest {
    @Rule public final TemporaryFolder folder = new TemporaryFolder();

    @Test public void readsSecondsColumnRowAndPolarity() throws Exception {
        ReadResult read = read("0.003811000 96 133 0\n0.003820001 127 171 1\r\n");
        assertEquals(List.of("3811 96 133 -1", "3820 127 171 1"), read.events);
        assertNull(read.error);
        assertEquals(List.of(), read.faults);
    }

    @Test public void takesTabsCommasCommentsAndEmptyLines() throws Exception {
        assertEquals(List.of("1000000 1 2 1", "2000000 3 4 -1"),
                read("# t x y p\n\n1,1,2,1\n \t\n2.0\t3\t4\t-1").events);
    }

    /** A double holds 1468940293.9551091 s only to 0.24 us. */
    @Test public void roundsTimesToMicrosecondsExactly() throws Exception {
        assertEquals(List.of("-1500000 0 0 1", "-1 0 0 1", "0 0 0 1", "15 0 0 1", "1468940293955109 0 0 1",
                "1468940293955110 0 0 1"),
                read("-1.5 0 0 1\n-.0000014 0 0 1\n1e-900000000 0 0 1\n1.5e-05 0 0 1\n1468940293.9551094 0 0 1\n"
                        + "1468940293.9551095 0 0 1\n").events);
    }

    @Test public void deliversEveryEventBeforeALineThatIsNone() throws Exception {
        String good = "1 2 3 1\n";
        assertDamaged(good + "12 4 7\n" + good, "[a.txt] line 2: malformed, expected \"t x y polarity\" but found 3 "
                + "fields: \"12 4 7\"");
        assertDamaged(good + "12 4",
                "[a.txt] line 2: truncated, expected \"t x y polarity\" but found 2 fields: \"12 4\"");
        assertDamaged(good + "x 4 7 1\n", "[a.txt] line 2: malformed, time must be a number of seconds: \"x 4 7 1\"");
        assertDamaged(good + "1 4.5 7 1\n", "[a.txt] line 2: malformed, x must be an integer: \"1 4.5 7 1\"");
        assertDamaged(good + "1 4 7 2\n", "[a.txt] line 2: malformed, polarity must be 1, 0 or -1 but was 2");
        assertDamaged(good + "1e99 4 7 1\n",
                "[a.txt] line 2: malformed, time must be smaller than 1000000000000 s but was 1e99");
        assertDamaged(good + "9".repeat(5000), "[a.txt] line 2: malformed, a line must have less than 4096 bytes: \""
                + "9".repeat(60) + "...\"");
    }

    @Test public void dropsAndReportsEventsOutsideTheSensor() throws Exception {
        ReadResult read = read("1 0 0 1\n2 240 0 1\n3 0 -1 1\n4 1 1 1\n");
        assertEquals(List.of("1000000 0 0 1", "4000000 1 1 1"), read.events);
        assertEquals(2, read.counts.outsideSensor());
        assertEquals(List.of("[a.txt] line 2: x must be smaller than width 240 but was 240 (the first of 2)"),
                read.faults);
    }

    @Test public void deliversStepsBackWithTheGreatestTime() throws Exception {
        ReadResult read = read("2 0 0 1\n1 0 0 1\n");
        assertEquals(List.of("2000000 0 0 1", "2000000 0 0 1"), read.events);
        assertEquals(List.of("[a.txt] line 2: time must not fall below 2000000 us but was 1000000 us"), read.faults);
    }

    @Test public void readsTheSameAfterATruncationAtAnyByte() throws Exception {
        String file = "0.1 1 2 1\n0.2 3 4 0\n";
        for (int length = 1; length < file.length(); length++) {
            ReadResult read = read(file.substring(0, length));
            int whole = length < 9 ? 0 : length < 19 ? 1 : 2;
            assertEquals(whole, read.events.size());
            boolean betweenEvents = length == 9 || length == 10 || length == 19;
            assertTrue("cut at " + length + ": " + read.error,
                    betweenEvents ? read.error == null : read.error.contains("truncated"));
        }
    }

    @Test public void asksForTheSize() throws Exception {
        String error = ReadResult.of(folder.getRoot().toPath(), "a.txt",
                "1.5 2 3 1\n".getBytes(StandardCharsets.US_ASCII), ReadResult.PLAIN).error;
        assertTrue(error, error.startsWith("[a.txt] the recording names no chip: --chip must name one of DVS128, ")
                && error.endsWith(" or a size such as 240x180; all its events lie within 34x34"));
    }

    private void assertDamaged(String text, String error) throws IOException {
        ReadResult read = read(text);
        assertEquals(error, read.error);
        assertEquals(List.of("1000000 2 3 1"), read.events);
    }

    private ReadResult read(String text) throws IOException {
        return ReadResult.of(folder.getRoot().toPath(), "a.txt", text.getBytes(StandardCharsets.US_ASCII),
                ReadResult.PLAIN.withChip("240x180").withTimeUnit(TextTimeUnit.S));
    }
}
