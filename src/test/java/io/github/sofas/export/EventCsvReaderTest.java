package io.github.sofas.export;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.EventSourceException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

public class EventCsvReaderTest {
    private static final String HEADER = "t_us,x,y,polarity,vx_px_per_s,vy_px_per_s,id";

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private EventCsvReader rows(String text) throws IOException, EventSourceException {
        Path file = folder.newFolder().toPath().resolve("a.csv");
        return EventCsvReader.open(Files.writeString(file, HEADER + "\n" + text), "id");
    }

    private float vx(String field) throws IOException, EventSourceException {
        try (EventCsvReader rows = rows("1,2,3,1," + field + ",0,0\n")) {
            assertTrue(rows.next());
            return rows.vxPxPerS();
        }
    }

    @Test
    public void readsEveryNumberAsTheLanguageDoes() throws Exception {
        for (String field : new String[] {"0", "-0", "12.5", "-58.25", ".5", "7.", "1e1", "-1.5E-3", "+4e2",
            "0.1", "16777217", "123456789012345678", "1234567890123456789012", "0.000000000000000000000123"}) {
            assertEquals(field, Float.parseFloat(field), vx(field), 0);
        }
        assertEquals("an empty field", 0, vx(""), 0);
    }

    @Test
    public void refusesWhatIsNoFiniteNumber() {
        for (String field : new String[] {"-", ".", "+", "1d", "0x1p3", "NaN", "Infinity", "1e99", "1.2.3", "1-",
            " 1"}) {
            assertEquals("[a.csv] line 2: vx_px_per_s must be a finite number but was \"" + field + "\"",
                assertThrows(field, EventSourceException.class, () -> vx(field)).getMessage());
        }
    }

    @Test
    public void timesOfAllRecordingsAreReadExactly() throws Exception {
        try (EventCsvReader rows = rows("999999999999999999,0,0,1,,,0\n-999999999999999999,0,0,1,,,0\n"
                + "9007199254740993,0,0,1,,,0\n1000000000000000000,0,0,1,,,0\n")) {
            for (long timeUs : new long[] {999_999_999_999_999_999L, -999_999_999_999_999_999L, (1L << 53) + 1}) {
                assertTrue(rows.next());
                assertEquals(timeUs, rows.timeUs());
            }
            assertEquals("[a.csv] line 5: t_us must be a whole number from -999999999999999999 to 999999999999999999 "
                + "but was \"1000000000000000000\"", assertThrows(EventSourceException.class, rows::next).getMessage());
        }
    }

    @Test
    public void linesMayLieAcrossTheEndOfTheBuffer() throws Exception {
        int lines = 20_000; // some 14 bytes each: four buffers
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < lines; i++) {
            text.append(i).append(",1,2,-1,,,").append(i).append('\n');
        }
        try (EventCsvReader rows = rows(text.toString())) {
            for (int i = 0; i < lines; i++) {
                assertTrue(rows.next());
                assertEquals(i, rows.timeUs());
                assertEquals(i, rows.id());
            }
            assertFalse(rows.next());
            assertFalse("asked again", rows.next());
        }
    }

    @Test
    public void lastLineMayLackItsEndAndIsSaidToBe() throws Exception {
        try (EventCsvReader rows = rows("1,2,3,1,,,0\n4,5,6,1,,,0")) {
            assertTrue(rows.next());
            rows.requireLineEnd();
            assertTrue(rows.next());
            assertEquals(4, rows.timeUs());
            assertEquals("[a.csv] line 3: must end with a new line but was \"4,5,6,1,,,0\"",
                assertThrows(EventSourceException.class, rows::requireLineEnd).getMessage());
            assertFalse(rows.next());
            assertFalse("asked again", rows.next());
        }
    }

    @Test
    public void emptyLineIsNoEnd() throws Exception {
        try (EventCsvReader rows = rows("\n1,2,3,1,,,0\n")) {
            assertEquals("[a.csv] line 2: must have 7 fields, " + HEADER + ", but was \"\"",
                assertThrows(EventSourceException.class, rows::next).getMessage());
        }
    }
}
