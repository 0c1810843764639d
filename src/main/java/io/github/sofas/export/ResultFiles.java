package io.github.sofas.export;

import java.io.File;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Files that appear together and whole, or not at all. Each is written beside its place under a hidden temporary name;
 * {@link #commit()} renames all of them. Closing without a commit deletes what was written, and so does the end of the
 * program by a signal. What a killed program left is deleted by the next that makes the same file, but for recordings:
 * no one can make those of a camera again.
 *
 * <p>The file that was started last gets its name last, and one of its name goes before the first is replaced: where it
 * is there, all are, of one run, even if the program was killed in the middle of a commit.
 */
public final class ResultFiles implements AutoCloseable {
    /** How long nothing was added to what a killed program left. */
    private static final long LEFT_MS = 60_000;
    private static final String RECORDING = ".aedat";

    private final Map<Path, Path> temporaryByFinal = new LinkedHashMap<>();
    private final Thread atShutdown = new Thread(this::discard, "discard unfinished results");
    private boolean over;

    /** Makes an empty group. */
    public ResultFiles() {
        try {
            Runtime.getRuntime().addShutdownHook(atShutdown);
        } catch (IllegalStateException e) {
            // The program is ending: nothing may be started.
            over = true;
        }
    }

    /**
     * Starts a file; its folder must exist.
     *
     * @param file where it will be after the commit; one that stands there until then is replaced
     * @return unbuffered; the caller closes it before the commit
     * @throws IOException where it cannot be made, or a directory has its name
     */
    public synchronized OutputStream create(Path file) throws IOException {
        if (over) {
            throw new IOException("the program is ending");
        }
        if (Files.isDirectory(file)) {
            // The commit would meet it only after other files have their names.
            throw new FileSystemException(file.toString(), null, "is a directory");
        }
        // The process id keeps two runs into one folder apart.
        Path temporary = file.resolveSibling("." + file.getFileName() + "." + ProcessHandle.current().pid() + ".part");
        deleteLeftovers(file);
        temporaryByFinal.put(file, temporary);
        return Files.newOutputStream(temporary, StandardOpenOption.CREATE, StandardOpenOption.TRUNCATE_EXISTING,
            StandardOpenOption.WRITE);
    }

    /** Deletes what programs wrote that were killed: they run no more, here, and nothing was added for a while. */
    private static void deleteLeftovers(Path file) {
        if (file.toString().endsWith(RECORDING)) {
            return;
        }
        Pattern left = Pattern.compile(Pattern.quote("." + file.getFileName() + ".") + "(\\d{1,18})\\.part");
        File[] siblings = file.toAbsolutePath().getParent().toFile().listFiles();
        for (File sibling : siblings == null ? new File[0] : siblings) {
            Matcher name = left.matcher(sibling.getName());
            // Another machine may write to the same folder.
            if (name.matches() && ProcessHandle.of(Long.parseLong(name.group(1))).isEmpty()
                    && System.currentTimeMillis() - sibling.lastModified() > LEFT_MS) {
                sibling.delete();
            }
        }
    }

    /**
     * {@return where a file that was started is until the commit, for writers that need more than a stream}
     *
     * @param file where it will be
     */
    public synchronized Path temporary(Path file) {
        return temporaryByFinal.get(file);
    }

    /**
     * Gives all files their names. A signal that arrives meanwhile waits until all have theirs.
     *
     * @throws IOException where one cannot be renamed or the program is ending
     */
    public synchronized void commit() throws IOException {
        if (over) {
            throw new IOException("the program is ending");
        }
        if (temporaryByFinal.size() > 1) {
            Path last = null;
            for (Path file : temporaryByFinal.keySet()) {
                last = file;
            }
            Files.deleteIfExists(last);
        }
        for (Map.Entry<Path, Path> entry : temporaryByFinal.entrySet()) {
            Files.move(entry.getValue(), entry.getKey(), StandardCopyOption.ATOMIC_MOVE);
        }
        over = true;
    }

    private synchronized void discard() {
        if (over) {
            return;
        }
        over = true;
        for (Path temporary : temporaryByFinal.values()) {
            // File.delete says nothing where the file is gone: there is no one left to tell.
            temporary.toFile().delete();
        }
    }

    /** Deletes what was not committed. */
    @Override
    public void close() {
        discard();
        try {
            Runtime.getRuntime().removeShutdownHook(atShutdown);
        } catch (IllegalStateException e) {
            // The program is ending already; the hook finds nothing to do.
            assert over;
        }
    }
}
