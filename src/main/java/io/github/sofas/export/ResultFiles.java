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
 * Files that appear together and whole, or not at all. Each is written beside its place under a hidden temporary name;
 * {@link #commit()} renames all of them. Closing without a commit deletes what was written, and so does the end of the
 * program by a signal. What a killed program left is deleted by the next that makes the same file.
 *
 * <p>What a camera sent cannot be sent again: files of a capture are kept, however the program ends, under their
 * temporary names where they cannot get others. {@link #leftBehind} finds them.
 *
 * <p>The file that was started last gets its name last, and one of its name goes before the first is replaced: where it
 * is there, all are, of one run, even if the program was killed in the middle of a commit.
 *
 * <p>Where nothing may be replaced, a file that another program makes meanwhile is not: of two that make the same one,
 * the second is refused when it starts, or else when it commits.
 */
public final class ResultFiles implements AutoCloseable {
    /** How long nothing was added to what a killed program left. */
    private static final long LEFT_MS = 60_000;
    /** By how much the clocks of processes and files may differ. */
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
     * @param replaces whether files may take the places of others
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
            // The program is ending: nothing may be started.
            over = true;
        }
    }

    /**
     * {@return an empty group for what cannot be made again}
     *
     * @param replaces whether files may take the places of others
     */
    public static ResultFiles ofCapture(boolean replaces) {
        return new ResultFiles(replaces, CAUGHT);
    }

    /** Notes that something was caught: from now on nothing of the group is deleted. */
    public synchronized void keepAll() {
        keepsAll = true;
    }

    /**
     * Starts a file; its folder must exist.
     *
     * @param file where it will be after the commit
     * @return unbuffered; the caller closes it before the commit
     * @throws IOException where it cannot be made, where a directory has its name, or where another program is making
     *     it and it may not be replaced
     */
    public synchronized OutputStream create(Path file) throws IOException {
        if (over) {
            throw new IOException("the program is ending");
        }
        if (Files.isDirectory(file)) {
            // The commit would meet it only after other files have their names.
            throw new FileSystemException(file.toString(), null, "is a directory");
        }
        if (Files.exists(file, LinkOption.NOFOLLOW_LINKS)
                && Files.readAttributes(file, BasicFileAttributes.class, LinkOption.NOFOLLOW_LINKS).isOther()) {
            // The commit would put a file in its place, and nobody could use the device any more.
            throw new FileSystemException(file.toString(), null, "is a device or a pipe and not a file");
        }
        // The process id keeps two runs into one folder apart.
        Path temporary = file.resolveSibling("." + file.getFileName() + "." + ProcessHandle.current().pid() + ending);
        lookAtOthers(file);
        OutputStream out = Files.newOutputStream(temporary, StandardOpenOption.CREATE,
            StandardOpenOption.TRUNCATE_EXISTING, StandardOpenOption.WRITE);
        temporaryByFinal.put(file, temporary);
        return out;
    }

    /**
     * Deletes what programs wrote that were killed: they run no more, here, and nothing was added for a while. One that
     * still runs was first.
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
            // Another machine may write to the same folder.
            if (!runs && name.group(2).equals("part")
                    && System.currentTimeMillis() - sibling.lastModified() > LEFT_MS) {
                sibling.delete();
            }
        }
    }

    /** Whether the process that began a file still runs; one that is younger than the file has only its number. */
    private static boolean runs(long pid, File file) {
        return ProcessHandle.of(pid).map(process -> process.info().startInstant()
            .map(start -> start.toEpochMilli() <= file.lastModified() + CLOCK_MS).orElse(true)).orElse(false);
    }

    /**
     * {@return files of captures whose programs were killed before these had their names}
     *
     * @param folder where they are looked for
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
     * {@return where a file that was started is until the commit, for writers that need more than a stream}
     *
     * @param file where it will be
     */
    public synchronized Path temporary(Path file) {
        return temporaryByFinal.get(file);
    }

    /** {@return where all files that were started are until the commit} */
    public synchronized List<Path> temporaries() {
        return List.copyOf(temporaryByFinal.values());
    }

    /**
     * {@return how many bytes the files that were started have, by name}
     *
     * @throws IOException where one cannot be looked at
     */
    public synchronized Map<String, Long> bytes() throws IOException {
        Map<String, Long> bytes = new LinkedHashMap<>();
        for (Map.Entry<Path, Path> entry : temporaryByFinal.entrySet()) {
            bytes.put(entry.getKey().getFileName().toString(), Files.size(entry.getValue()));
        }
        return bytes;
    }

    /**
     * Takes a file out of the group and deletes what was written of it.
     *
     * @param file that was started
     */
    public synchronized void forget(Path file) {
        Path temporary = temporaryByFinal.remove(file);
        if (temporary != null) {
            temporary.toFile().delete();
        }
    }

    /**
     * Gives all files their names. A signal that arrives meanwhile waits until all have theirs.
     *
     * @throws FileSystemException where one is there that may not be replaced; none has its name then, unless it
     *     came in this very moment
     * @throws IOException where one cannot be renamed or the program is ending
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

    /** Of two programs that do this at once, one fails. */
    private static void moveWithoutReplacing(Path from, Path to) throws IOException {
        try {
            Files.createLink(to, from);
        } catch (FileAlreadyExistsException e) {
            refuseToReplace(to);
            throw e;
        } catch (UnsupportedOperationException | FileSystemException e) {
            // a file system without links: the least time between looking and renaming
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
            // File.delete says nothing where the file is gone: there is no one left to tell.
            temporary.toFile().delete();
        }
    }

    /** Deletes what was not committed, unless it is to be kept. */
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
