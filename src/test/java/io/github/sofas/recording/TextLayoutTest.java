package io.github.sofas.recording;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** Columns and unit of text recordings: by option, by header, by the numbers. */
public class TextLayoutTest {
    @Rule public final TemporaryFolder folder = new TemporaryFolder();

    private RecordingOptions options = ReadResult.PLAIN.withChip("240x180");

    private ReadResult read(String text) throws IOException {
        return ReadResult.of(folder.getRoot().toPath(), "a.csv", text.getBytes(StandardCharsets.UTF_8), options);
    }

    /** Events every so many units, from a start. */
    private static String rows(int count, long first, long apart) {
        StringBuilder rows = new StringBuilder();
        for (int i = 0; i < count; i++) {
            rows.append(first + i * apart).append(",5,6,1\n");
        }
        return rows.toString();
    }

    @Test public void readsColumnsByTheNamesOfAHeader() throws Exception {
        assertEquals(List.of("7 1 2 1", "9 3 4 -1"), read("x,y,t_us,p\n1,2,7,1\n3,4,9,0\n").events);
        assertEquals(List.of("7 1 2 1"), read("\"Timestamp [us]\";\"X\";\"Y\";\"Polarity\"\n7;1;2;1\n").events);
        assertEquals(List.of("7 1 2 1"), read("# timestamp_us x y pol\n7 1 2 1\n").events);
        assertEquals(List.of("7 1 2 1"), read("# by hand\n\nts(us)\tcol\trow\ton\n7\t1\t2\t1\n").events);
    }

    @Test public void passesOverOtherColumnsAndFieldsThatAreEmpty() throws Exception {
        ReadResult read = read("t_us,x,y,polarity,vx_px_per_s,vy_px_per_s,segment\n7,1,2,1,,,0\n8,1,2,-1,3.5,-1,2\n");
        assertEquals(List.of("7 1 2 1", "8 1 2 -1"), read.events);
        assertEquals("[a.csv] line 3: malformed, expected \"t_us x y polarity note\" but found 4 fields: \"8,1,2,1\"",
                read("t_us,x,y,polarity,note\n7,1,2,1,\n8,1,2,1\n").error);
        assertEquals("[a.csv] line 2: malformed, x must be an integer: \"7,,2,1\"", read("t_us,x,y,p\n7,,2,1\n").error);
    }

    @Test public void readsWhatTablesWriteForNumbersAndPolarity() throws Exception {
        assertEquals(List.of("7 1 20 1", "8 0 2 -1", "9 0 0 1", "9 0 0 -1"), read("t_us,x,y,p\n7.0,1.0,20.00,True\n"
                + "8,0,2,false\n9,0,0,1.0\n9,0.0,0,-1.0\n").events);
        // the mark that spreadsheets put before UTF-8
        assertEquals(List.of("7 1 2 1"), read("\uFEFFt_us,x,y,p\r\n7,1,2,1\r\n").events);
    }

    @Test public void columnsAndUnitThatAreToldWin() throws Exception {
        options = options.withColumns(List.of("x", "y", "_", "p", "t")).withTimeUnit(TextTimeUnit.MS);
        assertEquals(List.of("7000 1 2 1"), read("1,2,99,1,7\n").events);
        assertEquals(List.of("7000 1 2 1"), read("a,b,c,d,e\n1,2,99,1,7\n").events);
        assertEquals(List.of("7000 1 2 1"), read("1 2 99 1 7 extra\n").events);
        assertThrows(IllegalArgumentException.class, () -> options.withColumns(List.of("t", "x", "y")));
        assertThrows(IllegalArgumentException.class, () -> options.withColumns(List.of("t", "x", "y", "p", "x")));
    }

    @Test public void readsEveryUnit() throws Exception {
        assertEquals(List.of("1500 0 0 1"), read("t[ms],x,y,p\n1.5,0,0,1\n").events);
        assertEquals(List.of("2 0 0 1", "2 0 0 1", "1468940293955110 0 0 1"),
                read("t_ns,x,y,p\n1500,0,0,1\n2499,0,0,1\n1468940293955109501,0,0,1\n").events);
        assertEquals(List.of("-1 0 0 1", "3000000 0 0 1"), read("time_s,x,y,p\n-0.0000014,0,0,1\n3,0,0,1\n").events);
    }

    /** 1000 events 10 apart are 100,000 a second as us; the span is that between the third and the third last. */
    @Test public void takesWholeNumbersForMicrosecondsWhereTheRateFitsAndSaysSo() throws Exception {
        ReadResult read = read(rows(1000, 5, 10));
        assertEquals("15 5 6 1", read.events.get(1));
        assertEquals(List.of("[a.csv] times are whole numbers without a unit; taken as us: about 1000 events in "
            + "0.00995 s, 100000 per second; --time s, ms, us or ns sets another"), read.notes);
    }

    @Test public void takesThousandsAndTheClockOf1970ForNanoseconds() throws Exception {
        assertEquals("15 5 6 1", read(rows(1000, 5_000, 10_000)).events.get(1));
        assertEquals("1600000000000000011 ns", "1600000000000000 5 6 1",
                read(rows(1000, 1_600_000_000_000_000_011L, 10_003)).events.get(0));
    }

    @Test public void refusesWholeNumbersThatFitNoUnit() throws Exception {
        // as us 1000 events in 10 ns
        assertEquals("[a.csv] line 1: malformed, the time unit must be given, but as us the recording would have "
            + "about 1000 events in 0 s; use --time s, ms, us or ns", read(rows(1000, 5, 0)).error);
        assertEquals("[a.csv] line 1: malformed, the time unit must be given, but as us the recording would have "
            + "about 200 events in 19500 s, 0.01 per second; use --time s, ms, us or ns",
                read(rows(200, 5, 100_000_001)).error);
        assertEquals("[a.csv] line 1: malformed, the time unit must be given, but 3 whole numbers do not show it; "
            + "use --time s, ms, us or ns", read(rows(3, 5, 10)).error);
    }

    /** A text file in microseconds with a fraction was read as seconds: no flow, and not a word. */
    @Test public void refusesFractionsThatAreNoSeconds() throws Exception {
        StringBuilder rows = new StringBuilder();
        for (int i = 0; i < 1000; i++) {
            rows.append(i * 10).append(".5 5 6 1\n");
        }
        assertEquals("[a.csv] line 1: malformed, the time unit must be given, but as s the recording would have "
            + "about 1000 events in 9950 s, 0.1 per second; use --time s, ms, us or ns",
                read(rows.toString()).error);
        options = options.withTimeUnit(TextTimeUnit.US);
        assertNull(read(rows.toString()).error);
    }

    @Test public void theWholeFileSaysTheRateNotItsFirstLines() throws Exception {
        // far more than is looked at: a burst first, then one event a millisecond
        String text = rows(20_000, 0, 0) + rows(20_000, 1, 1000);
        assertNull(read(text).error);
    }

    @Test public void refusesAFirstFieldThatIsNoTimeWhereAnotherIs() throws Exception {
        StringBuilder rows = new StringBuilder();
        for (int i = 0; i < 100; i++) {
            rows.append(i * 37 % 100).append(',').append(i * 53 % 100).append(",1,").append(100 * i).append('\n');
        }
        String error = read(rows.toString()).error;
        assertTrue(error, error.matches("\\[a.csv\\] line 1: malformed, the first field must be the time but falls "
                + "\\d+ times in 100 lines, while field \\d never does; --columns .*t.* says so, "
                + "if that is the order"));
    }

    @Test public void asksForColumnsThatAHeaderDoesNotName() throws Exception {
        assertEquals("[a.csv] line 1: unsupported, a header must name t, x, y and p, or --columns say which field is "
                + "which, but was \"frame,u,v\"", read("frame,u,v\n1,2,3\n").error);
    }

    @Test public void tellsEventsFromOtherText() throws Exception {
        Path file = folder.getRoot().toPath().resolve("a.txt");
        for (String events : List.of("0.1 1 2 1\n0.2 3 4 0\n", "x,y,p,t\n1,2,1,5\n", "# events\n1 2 3 1\n")) {
            assertTrue(events, Recordings.isText(Files.writeString(file, events)));
        }
        for (String other : List.of("", "Recorded on Monday, with the lens cap on.\n", "segment,first_t_us\n1,2\n",
                "a b c\n1 2 3\n")) {
            assertFalse(other, Recordings.isText(Files.writeString(file, other)));
        }
    }
}
