package io.github.sofas.export;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import io.github.sofas.Skipped;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
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
        try (ResultFiles files = new ResultFiles(true)) {
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
        try (ResultFiles files = new ResultFiles(true)) {
            write(files, first, "1");
            // Not closed: an exception may come in the middle of a file.
            files.create(second).write('2');
        }
        assertEquals(List.of(), filesThere());
    }

    @Test
    public void keepsAnOlderFileUntilTheCommitReplacesIt() throws IOException {
        Files.writeString(first, "older, and longer");
        try (ResultFiles files = new ResultFiles(true)) {
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
        try (ResultFiles files = new ResultFiles(true)) {
            write(files, first, "new");
        }
        assertEquals("older", Files.readString(first));
        assertEquals(List.of("a.csv"), filesThere());
    }

    @Test
    public void lastFileIsNotThereUntilAllOthersAreNew() throws IOException {
        Files.writeString(first, "older");
        Files.writeString(second, "older");
        try (ResultFiles files = new ResultFiles(true)) {
            write(files, first, "new");
            write(files, second, "new");
            // the commit stops where a file that it would rename is gone, as it would where the program is killed
            Files.delete(files.temporary(first));
            assertThrows(NoSuchFileException.class, files::commit);
            assertEquals("older", Files.readString(first));
        }
        assertEquals(List.of("a.csv"), filesThere());
    }

    @Test
    public void deletesWhatAKilledProgramLeft() throws IOException {
        // no process has so great a number
        Path left = Files.writeString(folder.getRoot().toPath().resolve(".a.csv.999999999999.part"), "half");
        Path fresh = Files.writeString(folder.getRoot().toPath().resolve(".a.csv.999999999998.part"), "half");
        Path other = Files.writeString(folder.getRoot().toPath().resolve(".b.csv.999999999999.part"), "half");
        for (Path old : List.of(left, other)) {
            Files.setLastModifiedTime(old, FileTime.fromMillis(System.currentTimeMillis() - 120_000));
        }
        try (ResultFiles files = new ResultFiles(true)) {
            write(files, first, "new");
            files.commit();
        }
        assertEquals(List.of(fresh.getFileName().toString(), other.getFileName().toString(), "a.csv"), filesThere());
    }

    /** A file of a capture whose program was killed. */
    private Path caught(String name) throws IOException {
        Path left = Files.writeString(folder.getRoot().toPath().resolve("." + name + ".999999999999.caught"), "half");
        return Files.setLastModifiedTime(left, FileTime.fromMillis(System.currentTimeMillis() - 120_000));
    }

    @Test
    public void keepsWhatAKilledProgramCaughtAndFindsIt() throws IOException {
        Path left = caught("live.aedat");
        try (ResultFiles files = ResultFiles.ofCapture(true)) {
            Path live = folder.getRoot().toPath().resolve("live.aedat");
            write(files, live, "new");
            assertEquals("but not what is being written", List.of(left),
                ResultFiles.leftBehind(folder.getRoot().toPath()));
            files.commit();
        }
        assertEquals(List.of(left.getFileName().toString(), "live.aedat"), filesThere());
    }

    @Test
    public void captureIsKeptWhereItCannotBeCommittedOnceSomethingWasCaught() throws IOException {
        try (ResultFiles files = ResultFiles.ofCapture(false)) {
            write(files, first, "1");
        }
        assertEquals("nothing was caught", List.of(), filesThere());
        try (ResultFiles files = ResultFiles.ofCapture(false)) {
            write(files, first, "1");
            files.keepAll();
        }
        assertEquals(List.of(".a.csv." + ProcessHandle.current().pid() + ".caught"), filesThere());
    }

    @Test
    public void whatAnotherProgramMadeMeanwhileIsNotReplaced() throws IOException {
        try (ResultFiles files = new ResultFiles(false)) {
            write(files, first, "mine");
            write(files, second, "mine");
            Files.writeString(second, "the other's");
            FileSystemException late = assertThrows(FileSystemException.class, files::commit);
            assertTrue(late.getMessage(), late.getMessage().matches("\\Q" + second + "\\E: another program made it at "
                + "\\d\\d:\\d\\d:\\d\\d and was first; --force replaces it"));
        }
        assertEquals(List.of("b.json"), filesThere());
        assertEquals("the other's", Files.readString(second));
        Files.createSymbolicLink(first, folder.getRoot().toPath().resolve("nowhere"));
        try (ResultFiles files = new ResultFiles(false)) {
            write(files, first, "mine");
            assertThrows("a link that leads nowhere is there too", FileSystemException.class, files::commit);
        }
    }

    @Test
    public void ofTwoProgramsThatMakeOneFileTheSecondIsRefusedAtItsStart() throws Exception {
        Process other = new ProcessBuilder("sleep", "60").start();
        try {
            Files.writeString(folder.getRoot().toPath().resolve(".a.csv." + other.pid() + ".part"), "half");
            try (ResultFiles files = new ResultFiles(false)) {
                FileSystemException refused = assertThrows(FileSystemException.class, () -> files.create(first));
                assertEquals(first + ": is being written by process " + other.pid()
                    + ", which was first; --force writes it too", refused.getMessage());
            }
            try (ResultFiles files = new ResultFiles(true)) {
                write(files, first, "forced");
                files.commit();
            }
        } finally {
            other.destroyForcibly().waitFor();
        }
        assertEquals("forced", Files.readString(first));
    }

    @Test
    public void leavesNothingWhereTheDiskIsFull() throws IOException {
        Path full = Path.of("/dev/full");
        if (!Files.isWritable(full)) {
            throw Skipped.because("there is no /dev/full");
        }
        Files.writeString(first, "older");
        String temporary = ".a.csv." + ProcessHandle.current().pid() + ".part";
        Files.createSymbolicLink(folder.getRoot().toPath().resolve(temporary), full);
        try (ResultFiles files = new ResultFiles(true)) {
            IOException refused = assertThrows(IOException.class, () -> write(files, first, "new"));
            assertEquals("No space left on device", refused.getMessage());
        }
        assertEquals(List.of("a.csv"), filesThere());
        assertEquals("older", Files.readString(first));
    }

    @Test
    public void refusesAFileWhoseNameADirectoryHas() throws IOException {
        Files.createDirectory(second);
        try (ResultFiles files = new ResultFiles(true)) {
            write(files, first, "1");
            FileSystemException refused = assertThrows(FileSystemException.class, () -> files.create(second));
            assertEquals(second + ": is a directory", refused.getMessage());
        }
        // Had the commit met it, a.csv would have had its name already.
        assertEquals(List.of("b.json"), filesThere());
    }

    /** A device would be replaced by a file, for all programs. */
    @Test
    public void refusesAPipeAndADevice() throws Exception {
        Process mkfifo;
        try {
            mkfifo = new ProcessBuilder("mkfifo", first.toString()).start();
        } catch (IOException e) {
            throw Skipped.because("this system makes no pipes: " + e.getMessage());
        }
        assertEquals(0, mkfifo.waitFor());
        try (ResultFiles files = new ResultFiles(true)) {
            FileSystemException refused = assertThrows(FileSystemException.class, () -> files.create(first));
            assertEquals(first + ": is a device or a pipe and not a file", refused.getMessage());
        }
        assertEquals(List.of("a.csv"), filesThere());
    }

    @Test
    public void refusesAFileInAFolderThatIsNotThere() {
        Path nowhere = folder.getRoot().toPath().resolve("nowhere").resolve("a.csv");
        try (ResultFiles files = new ResultFiles(true)) {
            assertThrows(NoSuchFileException.class, () -> files.create(nowhere));
        }
        assertEquals(List.of(), filesThere());
    }

    @Test
    public void startsAndCommitsNothingAfterItsEnd() throws IOException {
        ResultFiles files = new ResultFiles(true);
        write(files, first, "1");
        files.close();
        assertEquals("the program is ending",
            assertThrows(IOException.class, () -> files.create(second)).getMessage());
        assertEquals("the program is ending", assertThrows(IOException.class, files::commit).getMessage());
        files.close();
        assertTrue(filesThere().isEmpty());
    }
}
