package io.github.sofas.export;

import java.io.File;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A group of files that appear together and complete, or not at all. Each file is written beside its final place under
 * a hidden temporary name. {@link #commit()} renames all of them. Closing the group without a commit deletes the files
 * written so far, and so does a signal that ends the program. If a program was killed, the next one that makes the same
 * file deletes the remains.
 *
 * <p>The events of a camera cannot be sent again. The files of a capture are therefore kept, however the program ends.
 * If they cannot get their final names, they stay under their temporary ones, and {@link #leftBehind} finds them.
 *
 * <p>The file that was started last gets its name last. An existing file of that name is deleted before the first file
 * is replaced. So if the last file exists, all files exist and are of one run, even if the program was killed in the
 * middle of a commit.
 *
 * <p>If nothing may be replaced, this holds also for files that another program makes meanwhile. Of two programs that
 * make the same file, the second is refused, when it starts the file or else when it commits.
 */
public final class ResultFiles implements AutoCloseable {
    /** Time for which nothing may have been added to a file before it counts as left by a killed program, ms. */
    private static final long LEFT_MS = 60_000;
    /** Largest difference between the clocks of processes and files, ms. */
    private static final long CLOCK_MS = 2000;
    private static final String PART = ".part";
    private static final String CAUGHT = ".caught";

    private final Map<Path, Path> temporaryByFinal = new LinkedHashMap<>();
    private final Thread atShutdown = new Thread(this::discard, "discard unfinished results");
    private final boolean replaces;
    private final String ending;
    private boolean keepsAll;
    private boolean over;

    /**
     * Makes an empty group.
     *
     * @param replaces whether files may replace existing ones
     */
    public ResultFiles(boolean replaces) {
        this(replaces, PART);
    }

    private ResultFiles(boolean replaces, String ending) {
        this.replaces = replaces;
        this.ending = ending;
        try {
            Runtime.getRuntime().addShutdownHook(atShutdown);
        } catch (IllegalStateException e) {
            // The program is ending: no file may be started.
            over = true;
        }
    }

    /**
     * {@return an empty group for a capture, whose events cannot be recorded again}
     *
     * @param replaces whether files may replace existing ones
     */
    public static ResultFiles ofCapture(boolean replaces) {
        return new ResultFiles(replaces, CAUGHT);
    }

    /**
     * Notes that events were captured. From now on, neither {@link #close()} nor a signal deletes files of the group.
     */
    public synchronized void keepAll() {
        keepsAll = true;
    }

    /**
     * Starts a file. Its folder must exist.
     *
     * @param file path of the file after the commit
     * @return an unbuffered stream; the caller closes it before the commit
     * @throws IOException if the file cannot be made, if a directory has its name, or if another program is making it
     *     and it may not be replaced
     */
    public synchronized OutputStream create(Path file) throws IOException {
        if (over) {
            throw new IOException("the program is ending");
        }
        if (Files.isDirectory(file)) {
            // The commit would fail only after other files have their names.
            throw new FileSystemException(file.toString(), null, "is a directory");
        }
        if (Files.exists(file, LinkOption.NOFOLLOW_LINKS)
                && Files.readAttributes(file, BasicFileAttributes.class, LinkOption.NOFOLLOW_LINKS).isOther()) {
            // The commit would replace it by a file, and nobody could use the device any more.
            throw new FileSystemException(file.toString(), null, "is a device or a pipe and not a file");
        }
        // The process id distinguishes two runs that write to one folder.
        Path temporary = file.resolveSibling("." + file.getFileName() + "." + ProcessHandle.current().pid() + ending);
        lookAtOthers(file);
        OutputStream out = Files.newOutputStream(temporary, StandardOpenOption.CREATE,
            StandardOpenOption.TRUNCATE_EXISTING, StandardOpenOption.WRITE);
        temporaryByFinal.put(file, temporary);
        return out;
    }

    /**
     * Deletes the unfinished file of a program that was killed: its process does not run on this machine, and nothing
     * was added for a while. Refuses to start the file if another process is still writing it and files may not be
     * replaced.
     */
    private void lookAtOthers(Path file) throws IOException {
        Pattern part = Pattern.compile(Pattern.quote("." + file.getFileName() + ".") + "(\\d{1,18})\\.(part|caught)");
        File[] siblings = file.toAbsolutePath().getParent().toFile().listFiles();
        for (File sibling : siblings == null ? new File[0] : siblings) {
            Matcher name = part.matcher(sibling.getName());
            long pid = name.matches() ? Long.parseLong(name.group(1)) : ProcessHandle.current().pid();
            if (pid == ProcessHandle.current().pid()) {
                continue;
            }
            boolean runs = runs(pid, sibling);
            if (runs && !replaces) {
                throw new FileSystemException(file.toString(), null, "is being written by process " + pid
                    + ", which was first; --force writes it too");
            }
            // The wait is for programs on other machines, which may write to the same folder.
            if (!runs && name.group(2).equals("part")
                    && System.currentTimeMillis() - sibling.lastModified() > LEFT_MS) {
                sibling.delete();
            }
        }
    }

    /**
     * Whether the process that began a file still runs. A process that is younger than the file merely has the same
     * number.
     */
    private static boolean runs(long pid, File file) {
        return ProcessHandle.of(pid).map(process -> process.info().startInstant()
            .map(start -> start.toEpochMilli() <= file.lastModified() + CLOCK_MS).orElse(true)).orElse(false);
    }

    /**
     * {@return files of captures whose programs were killed before the files got their final names}
     *
     * @param folder the folder to search
     */
    public static List<Path> leftBehind(Path folder) {
        List<Path> left = new ArrayList<>();
        Pattern caught = Pattern.compile("\\..+\\.(\\d{1,18})\\.caught");
        File[] files = folder.toFile().listFiles();
        for (File file : files == null ? new File[0] : files) {
            Matcher name = caught.matcher(file.getName());
            if (name.matches() && !runs(Long.parseLong(name.group(1)), file)) {
                left.add(file.toPath());
            }
        }
        left.sort(Comparator.naturalOrder());
        return left;
    }

    /**
     * {@return the temporary path of a started file, until the commit, for writers that need more than a stream}
     *
     * @param file path of the file after the commit
     */
    public synchronized Path temporary(Path file) {
        return temporaryByFinal.get(file);
    }

    /** {@return the temporary paths of all started files, which hold until the commit} */
    public synchronized List<Path> temporaries() {
        return List.copyOf(temporaryByFinal.values());
    }

    /**
     * {@return the sizes of the started files in bytes, by name}
     *
     * @throws IOException if a size cannot be read
     */
    public synchronized Map<String, Long> bytes() throws IOException {
        Map<String, Long> bytes = new LinkedHashMap<>();
        for (Map.Entry<Path, Path> entry : temporaryByFinal.entrySet()) {
            bytes.put(entry.getKey().getFileName().toString(), Files.size(entry.getValue()));
        }
        return bytes;
    }

    /**
     * Removes a file from the group and deletes its temporary file.
     *
     * @param file path that the file would have after the commit
     */
    public synchronized void forget(Path file) {
        Path temporary = temporaryByFinal.remove(file);
        if (temporary != null) {
            temporary.toFile().delete();
        }
    }

    /**
     * Gives all files their final names. A signal that arrives meanwhile takes effect when all have them.
     *
     * @throws FileSystemException if a file exists that may not be replaced; then none has its final name, unless the
     *     existing file appeared in this very moment
     * @throws IOException if a file cannot be renamed, or if the program is ending
     */
    public synchronized void commit() throws IOException {
        if (over) {
            throw new IOException("the program is ending");
        }
        if (!replaces) {
            for (Path file : temporaryByFinal.keySet()) {
                refuseToReplace(file);
            }
        } else if (temporaryByFinal.size() > 1) {
            Path last = null;
            for (Path file : temporaryByFinal.keySet()) {
                last = file;
            }
            Files.deleteIfExists(last);
        }
        for (Map.Entry<Path, Path> entry : temporaryByFinal.entrySet()) {
            if (replaces) {
                Files.move(entry.getValue(), entry.getKey(), StandardCopyOption.ATOMIC_MOVE);
            } else {
                moveWithoutReplacing(entry.getValue(), entry.getKey());
            }
        }
        over = true;
    }

    private static void refuseToReplace(Path file) throws IOException {
        if (Files.exists(file, LinkOption.NOFOLLOW_LINKS)) {
            String since = DateTimeFormatter.ofPattern("HH:mm:ss", Locale.ROOT).format(
                Files.getLastModifiedTime(file, LinkOption.NOFOLLOW_LINKS).toInstant().atZone(ZoneId.systemDefault()));
            throw new FileSystemException(file.toString(), null, "another program made it at " + since
                + " and was first; --force replaces it");
        }
    }

    /** Renames a file, unless one of the new name exists. Of two programs that do this at once, one fails. */
    private static void moveWithoutReplacing(Path from, Path to) throws IOException {
        try {
            Files.createLink(to, from);
        } catch (FileAlreadyExistsException e) {
            refuseToReplace(to);
            throw e;
        } catch (UnsupportedOperationException | FileSystemException e) {
            // a file system without links: the time between the check and the renaming is as short as possible
            refuseToReplace(to);
            Files.move(from, to, StandardCopyOption.ATOMIC_MOVE);
            return;
        }
        Files.delete(from);
    }

    private synchronized void discard() {
        if (over) {
            return;
        }
        over = true;
        if (keepsAll) {
            return;
        }
        for (Path temporary : temporaryByFinal.values()) {
            // File.delete does not report a missing file: nobody is left to read the report.
            temporary.toFile().delete();
        }
    }

    /** Deletes files that were not committed, unless they are to be kept. */
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
