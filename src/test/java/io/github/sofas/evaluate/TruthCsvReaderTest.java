package io.github.sofas.evaluate;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;

import io.github.sofas.event.EventBatch;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

public class TruthCsvReaderTest {
    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    /** Two events: one of an object, one of noise. */
    private static EventBatch recording() {
        EventBatch batch = new EventBatch(3);
        batch.add(100, 3, 4, 1);
        batch.add(105, 7, 0, -1);
        return batch;
    }

    private GroundTruth read(String... lines) throws TruthException, IOException {
        Path file = folder.getRoot().toPath().resolve("edge.truth.csv");
        Files.write(file, (String.join("\n", lines) + (lines.length == 0 ? "" : "\n"))
                .getBytes(StandardCharsets.UTF_8));
        try (TruthCsvReader reader = TruthCsvReader.open(file)) {
            reader.read(recording(), new boolean[2]);
            reader.end();
            return reader.truth();
        }
    }

    private void assertRefuses(String message, String... lines) {
        TruthException e = assertThrows(TruthException.class, () -> read(lines));
        assertEquals("[edge.truth.csv] " + message, e.getMessage());
    }

    @Test
    public void readsOneLineForEveryEvent() throws TruthException, IOException {
        GroundTruth truth = read(TruthCsvReader.HEADER, "100,3,4,1,-58.25,1e1,12", "105,7,0,-1,,,0");
        assertArrayEquals(new long[] {100, 105}, truth.timeUs());
        assertArrayEquals(new float[] {-58.25f, 0}, truth.vxPxPerS(), 0);
        assertArrayEquals(new float[] {10, 0}, truth.vyPxPerS(), 0);
        assertArrayEquals(new int[] {12, 0}, truth.object());
    }

    @Test
    public void refusesALineThatIsNoText() {
        assertRefuses("line 1: must have at most 1000 characters but begins with \"" + "?".repeat(100) + "...\"",
            "\0".repeat(1001));
    }

    @Test
    public void refusesALineThatIsTooLong() {
        assertRefuses("line 2: must have at most 1000 characters but begins with \"" + "1".repeat(100) + "...\"",
            TruthCsvReader.HEADER, "1".repeat(5000));
    }

    @Test
    public void readsLinesThatEndInCarriageReturns() throws TruthException, IOException {
        assertEquals(2, read(TruthCsvReader.HEADER + "\r", "100,3,4,1,5,0,1\r", "105,7,0,-1,0,0,0\r").size());
    }

    @Test
    public void namesTheLineWhereTruthAndRecordingDiffer() {
        assertRefuses("line 3: must be event 1 of the recording (t_us 105, x 7, y 0, polarity -1) or one after it "
                + "but was (t_us 105, x 7, y 1, polarity -1)", TruthCsvReader.HEADER, "100,3,4,1,5,0,1",
                "105,7,1,-1,0,0,0");
    }

    @Test
    public void takesATruthOfAPartOfTheEvents() throws TruthException, IOException {
        assertEquals(1, read(TruthCsvReader.HEADER, "100,3,4,1,5,0,1").size());
        GroundTruth second = read(TruthCsvReader.HEADER, "105,7,0,-1,6,0,2");
        assertEquals(1, second.size());
        assertEquals(2, second.object()[0]);
        assertEquals(0, read(TruthCsvReader.HEADER).size());
    }

    @Test
    public void takesColumnsInAnyOrderAndAmongOthers() throws TruthException, IOException {
        GroundTruth truth = read("object,weather,y,x,t_us,vy_px_per_s,vx_px_per_s,polarity", "3,sun,4,3,100,-1,5,1",
            "0,,0,7,105,,,-1");
        assertEquals(2, truth.size());
        assertEquals(3, truth.object()[0]);
        assertEquals(5, truth.vxPxPerS()[0], 0);
        assertEquals(-1, truth.vyPxPerS()[0], 0);
    }

    @Test
    public void refusesATruthThatIsLongerThanTheRecording() {
        assertRefuses("line 4: must not be there, as the recording has 2 events, but was \"200,0,0,1,0,0,0\"",
                TruthCsvReader.HEADER, "100,3,4,1,5,0,1", "105,7,0,-1,0,0,0", "200,0,0,1,0,0,0");
    }

    @Test
    public void refusesAnotherFirstLine() {
        assertRefuses("line 1: must be \"t_us,x,y,polarity,vx_px_per_s,vy_px_per_s,object\" but was "
                + "\"t_us,x,y,polarity,vx_px_per_s,vy_px_per_s,segment\"",
                "t_us,x,y,polarity,vx_px_per_s,vy_px_per_s,segment");
    }

    @Test
    public void refusesAnEmptyFile() {
        assertRefuses("line 1: must be \"t_us,x,y,polarity,vx_px_per_s,vy_px_per_s,object\" but the file is empty");
    }

    @Test
    public void refusesTooFewFields() {
        assertRefuses("line 2: must have 7 fields, t_us,x,y,polarity,vx_px_per_s,vy_px_per_s,object, but was "
                + "\"100,3,4,1,5,0\"", TruthCsvReader.HEADER, "100,3,4,1,5,0");
    }

    @Test
    public void refusesTooManyFields() {
        assertRefuses("line 2: must have 7 fields, t_us,x,y,polarity,vx_px_per_s,vy_px_per_s,object, but was "
                + "\"100,3,4,1,5,0,1,9\"", TruthCsvReader.HEADER, "100,3,4,1,5,0,1,9");
    }

    @Test
    public void refusesWhatIsNoNumber() {
        assertRefuses("line 2: x must be a whole number from 0 to 32767 but was \"3.5\"",
                TruthCsvReader.HEADER, "100,3.5,4,1,5,0,1");
    }

    @Test
    public void refusesAVelocityThatIsNotFinite() {
        assertRefuses("line 2: vy_px_per_s must be a finite number but was \"NaN\"",
                TruthCsvReader.HEADER, "100,3,4,1,5,NaN,1");
    }

    @Test
    public void refusesAnObjectWithoutVelocity() {
        assertRefuses("line 2: vx_px_per_s must be a finite number but was \"\"",
                TruthCsvReader.HEADER, "100,3,4,1,,,1");
    }

    @Test
    public void refusesANegativeObject() {
        assertRefuses("line 2: object must be a whole number from 0 to 2147483647 but was \"-1\"",
                TruthCsvReader.HEADER, "100,3,4,1,5,0,-1");
    }
}
