package io.github.sofas.export;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

public class ResultFilesTest {
    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private Path first;
    private Path second;

    @Before
    public void names() {
        first = folder.getRoot().toPath().resolve("a.csv");
        second = folder.getRoot().toPath().resolve("b.json");
    }

    private static void write(ResultFiles files, Path file, String text) throws IOException {
        try (OutputStream out = files.create(file)) {
            out.write(text.getBytes(StandardCharsets.UTF_8));
        }
    }

    private List<String> filesThere() {
        String[] names = folder.getRoot().list();
        Arrays.sort(names);
        return List.of(names);
    }

    @Test
    public void writesNothingUnderTheFinalNameBeforeTheCommit() throws IOException {
        try (ResultFiles files = new ResultFiles()) {
            write(files, first, "1");
            write(files, second, "2");
            String end = "." + ProcessHandle.current().pid() + ".part";
            assertEquals(List.of(".a.csv" + end, ".b.json" + end), filesThere());
            files.commit();
            assertEquals(List.of("a.csv", "b.json"), filesThere());
        }
        assertEquals(List.of("a.csv", "b.json"), filesThere());
        assertEquals("1", Files.readString(first));
        assertEquals("2", Files.readString(second));
    }

    @Test
    public void deletesWhatWasNotCommitted() throws IOException {
        try (ResultFiles files = new ResultFiles()) {
            write(files, first, "1");
            // Not closed: an exception may come in the middle of a file.
            files.create(second).write('2');
        }
        assertEquals(List.of(), filesThere());
    }

    @Test
    public void keepsAnOlderFileUntilTheCommitReplacesIt() throws IOException {
        Files.writeString(first, "older, and longer");
        try (ResultFiles files = new ResultFiles()) {
            write(files, first, "new");
            assertEquals("older, and longer", Files.readString(first));
            files.commit();
        }
        assertEquals("new", Files.readString(first));
        assertEquals(List.of("a.csv"), filesThere());
    }

    @Test
    public void keepsAnOlderFileWhereThereIsNoCommit() throws IOException {
        Files.writeString(first, "older");
        try (ResultFiles files = new ResultFiles()) {
            write(files, first, "new");
        }
        assertEquals("older", Files.readString(first));
        assertEquals(List.of("a.csv"), filesThere());
    }

    @Test
    public void refusesAFileWhoseNameADirectoryHas() throws IOException {
        Files.createDirectory(second);
        try (ResultFiles files = new ResultFiles()) {
            write(files, first, "1");
            FileSystemException refused = assertThrows(FileSystemException.class, () -> files.create(second));
            assertEquals(second + ": is a directory", refused.getMessage());
        }
        // Had the commit met it, a.csv would have had its name already.
        assertEquals(List.of("b.json"), filesThere());
    }

    @Test
    public void refusesAFileInAFolderThatIsNotThere() {
        Path nowhere = folder.getRoot().toPath().resolve("nowhere").resolve("a.csv");
        try (ResultFiles files = new ResultFiles()) {
            assertThrows(NoSuchFileException.class, () -> files.create(nowhere));
        }
        assertEquals(List.of(), filesThere());
    }

    @Test
    public void startsAndCommitsNothingAfterItsEnd() throws IOException {
        ResultFiles files = new ResultFiles();
        write(files, first, "1");
        files.close();
        assertEquals("the program is ending",
            assertThrows(IOException.class, () -> files.create(second)).getMessage());
        assertEquals("the program is ending", assertThrows(IOException.class, files::commit).getMessage());
        files.close();
        assertTrue(filesThere().isEmpty());
    }
}
