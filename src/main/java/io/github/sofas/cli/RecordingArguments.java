package io.github.sofas.cli;

import io.github.sofas.recording.Recordings;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.nio.file.PathMatcher;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.function.BooleanSupplier;
import java.util.function.Predicate;
import java.util.regex.PatternSyntaxException;
import java.util.stream.Stream;

/**
 * Finds the recordings that a command line names, and the names of their results. Arguments are files, directories, or
 * patterns that no shell has expanded. A directory stands for all recordings in it, but not for those of its
 * subdirectories.
 */
final class RecordingArguments {
    /**
     * Extensions that a directory is searched for. A text file must also begin with events and be no result of this
     * program, because notes and results are text, too.
     */
    static final List<String> EXTENSIONS = List.of("aedat", "aedat2", "aedat3", "aedat4", "dat", "raw", "es",
        "bin", "h5", "hdf5", "csv", "txt");
    private static final List<String> TEXT = List.of("csv", "txt");
    /** Endings of results with one row per event, and of truth: text that reads as a recording but is none. */
    private static final List<String> RESULTS = List.of(".flow.csv", ".truth.csv");

    private static final String WILDCARDS = "*?[{";
    /** The character that replaces bytes of an argument that are no characters. */
    private static final char UNREADABLE = '\uFFFD';
    /** Encoding of file names. */
    private static final String ENCODING = System.getProperty("sun.jnu.encoding", "this system's encoding");

    private RecordingArguments() {
    }

    /**
     * Expands arguments in their order, and directories and patterns in the order of names; each file is listed once.
     *
     * @throws IllegalArgumentException if an argument matches nothing; the message is for the user
     */
    static List<Path> expand(List<String> arguments) {
        Set<Path> seen = new LinkedHashSet<>();
        List<Path> recordings = new ArrayList<>();
        for (String argument : arguments) {
            for (Path path : expand(argument)) {
                if (seen.add(path.toAbsolutePath().normalize())) {
                    recordings.add(path);
                }
            }
        }
        return recordings;
    }

    private static List<Path> expand(String argument) {
        if (argument.isEmpty()) {
            // comes from an unset variable of the shell, and does not mean the current directory
            throw new IllegalArgumentException("a recording must be a file, a directory or a pattern but was empty");
        }
        Path path;
        try {
            path = Path.of(argument);
        } catch (InvalidPathException e) {
            throw new IllegalArgumentException("[" + argument + "] is no path: " + e.getReason(), e);
        }
        if (Files.isDirectory(path)) {
            List<Path> found = list(path, 1, RecordingArguments::looksLikeRecording);
            if (found.isEmpty()) {
                throw new IllegalArgumentException("[" + argument + "] no recording in this directory: extensions are "
                    + String.join(", ", EXTENSIONS));
            }
            return found;
        }
        if (Files.exists(path)) {
            return List.of(path);
        }
        if (isPattern(argument)) {
            List<Path> found;
            try {
                found = match(path);
            } catch (PatternSyntaxException e) {
                throw new IllegalArgumentException("[" + argument + "] no such file, and no pattern: "
                    + e.getDescription(), e);
            }
            if (found.isEmpty()) {
                throw new IllegalArgumentException("[" + argument + "] no file matches this pattern");
            }
            return found;
        }
        throw new IllegalArgumentException("[" + argument + "] no such file" + (argument.indexOf(UNREADABLE) < 0 ? ""
            : "; one whose name is not in " + ENCODING + " is reached by its directory or a quoted pattern"));
    }

    /** Whether an argument may stand for many files. */
    static boolean isPattern(String argument) {
        return argument.chars().anyMatch(c -> WILDCARDS.indexOf(c) >= 0);
    }

    private static boolean looksLikeRecording(Path file) {
        return looksLikeRecording(file.getFileName().toString(), () -> Recordings.isText(file));
    }

    /**
     * Whether a file of a directory is taken for a recording.
     *
     * @param fileName its name
     * @param isText determines whether the file begins with events as text; called only if the name leaves it open
     */
    static boolean looksLikeRecording(String fileName, BooleanSupplier isText) {
        String name = fileName.toLowerCase(Locale.ROOT);
        return !name.startsWith(".") && EXTENSIONS.stream().anyMatch(known -> name.endsWith("." + known))
            && (TEXT.stream().noneMatch(known -> name.endsWith("." + known))
                || RESULTS.stream().noneMatch(name::endsWith) && isText.getAsBoolean());
    }

    private static List<Path> match(Path pattern) {
        // The search starts in the folder before the first wildcard.
        Path start = pattern.isAbsolute() ? pattern.getRoot() : Path.of("");
        int fixed = 0;
        while (pattern.getName(fixed).toString().chars().noneMatch(c -> WILDCARDS.indexOf(c) >= 0)) {
            start = start.resolve(pattern.getName(fixed));
            fixed++;
        }
        if (!Files.isDirectory(start)) {
            return List.of();
        }
        Path rest = pattern.subpath(fixed, pattern.getNameCount());
        PathMatcher matcher = FileSystems.getDefault().getPathMatcher("glob:" + rest);
        int depth = rest.toString().contains("**") ? Integer.MAX_VALUE : rest.getNameCount();
        Path from = start;
        // As in a shell, a wildcard does not match the dot of a hidden name. Unfinished results have such names.
        boolean hiddenToo = isHidden(rest);
        return list(start, depth, file -> {
            Path relative = from.relativize(file);
            return matcher.matches(relative) && (hiddenToo || !isHidden(relative));
        });
    }

    /** Whether the file or one of the folders above it has a name that begins with a dot. */
    private static boolean isHidden(Path path) {
        for (Path name : path) {
            if (name.toString().startsWith(".")) {
                return true;
            }
        }
        return false;
    }

    /**
     * Whether a file may be a recording. A link that leads nowhere is not skipped silently: it fails when it is opened.
     */
    private static boolean mayBeRecording(Path file) {
        return Files.isRegularFile(file) || Files.isSymbolicLink(file) && !Files.exists(file);
    }

    private static List<Path> list(Path folder, int depth, Predicate<Path> wanted) {
        try (Stream<Path> files = Files.walk(folder, depth)) {
            return files.filter(RecordingArguments::mayBeRecording).filter(wanted).sorted().toList();
        } catch (IOException | UncheckedIOException e) {
            throw new IllegalArgumentException("[" + folder + "] cannot be listed: " + e.getMessage(), e);
        }
    }

    /**
     * Names the results of each recording, in the order given.
     *
     * @param withExtension whether the last extension is kept
     * @throws IllegalArgumentException if two recordings have the same name, or a name cannot be that of a file; the
     *     message is for the user
     */
    static Map<String, Path> byName(List<Path> recordings, boolean withExtension) {
        Map<String, Path> named = new LinkedHashMap<>();
        for (Path recording : recordings) {
            String name = name(recording, withExtension);
            checkResultsCanBeNamed(recording, name);
            Path other = named.putIfAbsent(name, recording);
            if (other != null) {
                throw new IllegalArgumentException("[" + recording + "] results must have different names but those of "
                    + other + " are named \"" + name + "\" too"
                    + (name(other, true).equals(name(recording, true)) ? "" : "; --name-with-extension keeps both"));
            }
        }
        return named;
    }

    /** Refuses a name whose bytes are no characters: it can be read from a directory, but not be written everywhere. */
    private static void checkResultsCanBeNamed(Path recording, String name) {
        try {
            Path.of(name);
        } catch (InvalidPathException e) {
            throw new IllegalArgumentException("[" + recording + "] results cannot be named after it: the name must be "
                + "in " + ENCODING + " but is not", e);
        }
    }

    private static String name(Path recording, boolean withExtension) {
        String name = recording.getFileName().toString();
        int dot = name.lastIndexOf('.');
        return withExtension || dot <= 0 ? name : name.substring(0, dot);
    }
}
