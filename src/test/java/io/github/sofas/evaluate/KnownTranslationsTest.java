package io.github.sofas.evaluate;

import static org.junit.Assert.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

public class KnownTranslationsTest {
    private static final String HEADER = "recording,from_us,until_us,events,vx_px_per_s,vy_px_per_s";

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private List<String> readAndWritten(String... lines) throws IOException {
        Path file = folder.getRoot().toPath().resolve("known.csv");
        Files.write(file, List.of(lines));
        KnownTranslations.read(file).write(file);
        return Files.readAllLines(file);
    }

    @Test
    public void whatIsWrittenIsReadAgain() throws IOException {
        assertEquals(List.of(HEADER, "a, b.aedat,-5,300000,17,-12.5,0.0", "c.aedat,0,1,2,1.0E-4,2.0E7"),
            readAndWritten(HEADER, "a, b.aedat,-5,300000,17,-12.5,0.0", "c.aedat,0,1,2,1.0E-4,2.0E7"));
    }

    @Test
    public void lineOfAnotherFormIsPassedOver() throws IOException {
        assertEquals(List.of(HEADER, "a,0,1,2,3.0,4.0"),
            readAndWritten("a,0,1,2,3,4", "a,0,1,2,3,four", "notes, with, commas", "a,0,1,2,NaN,1", "b,0,1,2,3", ""));
    }

    @Test
    public void nothingIsKnownWhereThereIsNoFile() throws IOException {
        Path file = folder.getRoot().toPath().resolve("none.csv");
        KnownTranslations.read(file).write(file);
        assertEquals(List.of(HEADER), Files.readAllLines(file));
    }
}
