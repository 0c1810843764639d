package io.github.sofas.jaer;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.Stream;

/**
 * Main class of the jar: {@code java -jar sofas-jAER.jar [OPTION]... DIR [RECORDING]} starts the jAER in a folder, with
 * the filter in its list. The options go to jAER's Java.
 */
public final class StartJaer {
    private static final String USAGE = "usage: java -jar sofas-jAER.jar [JAVA_OPTION]... JAER_FOLDER [RECORDING]\n"
        + "Starts the jAER in a folder, with SOFAS among its filters. Options as -Xmx4g and -Dname=value go to its"
        + " Java.";
    /**
     * Option that has jAER 3 pass samples of the inertial sensor to its flow filters, which take true motion from them.
     */
    private static final String INERTIAL_SAMPLES = "-Djaer.legacyExtractBundle=";

    /** Longest time that jAER may take to end: on a signal to end, it asks the user nothing. */
    private static final int LONGEST_END_S = 5;

    private StartJaer() {
    }

    /** Ends with jAER's exit code, with 1 if jAER cannot be started, or with 2 on wrong usage. */
    public static void main(String[] arguments) throws InterruptedException {
        int options = 0;
        while (options < arguments.length && arguments[options].startsWith("-")) {
            options++;
        }
        int rest = arguments.length - options;
        if (rest < 1 || rest > 2) {
            System.err.println(USAGE);
            System.exit(2);
        }
        List<String> all = Arrays.asList(arguments);
        try {
            System.exit(start(all.subList(0, options), Path.of(arguments[options]),
                all.subList(options + 1, arguments.length)));
        } catch (IOException e) {
            System.err.println(e.getMessage());
            System.exit(1);
        }
    }

    private static int start(List<String> options, Path folder, List<String> recordings)
            throws IOException, InterruptedException {
        JaerFolder jaer = JaerFolder.of(folder);
        for (String recording : recordings) {
            if (!Files.isReadable(Path.of(recording))) {
                throw new IOException("[" + recording + "] no such file, or not readable");
            }
        }
        Path overlay = Files.createTempDirectory("sofas-jaer");
        AtomicReference<Process> process = endedWithThis(overlay);
        List<String> command = jaer.command(overlay, withInertialSamples(options), "net.sf.jaer.JAERViewer");
        // jAER runs in its own folder
        recordings.forEach(recording -> command.add(Path.of(recording).toAbsolutePath().toString()));
        return run(command, jaer.folder(), process);
    }

    /** Adds the option for inertial samples, unless the user has set it to any value. */
    private static List<String> withInertialSamples(List<String> options) {
        List<String> all = new ArrayList<>(options);
        if (options.stream().noneMatch(option -> option.startsWith(INERTIAL_SAMPLES))) {
            all.add(INERTIAL_SAMPLES + true);
        }
        return all;
    }

    /**
     * Ends another process and then deletes the folder that it uses when this process ends, also by a signal.
     *
     * @return the reference that the caller sets to that process
     */
    static AtomicReference<Process> endedWithThis(Path scratch) {
        AtomicReference<Process> process = new AtomicReference<>();
        Runtime.getRuntime().addShutdownHook(new Thread(() -> end(process.get(), scratch)));
        return process;
    }

    /** Runs a command with the input and output of this process, and returns its exit code. */
    static int run(List<String> command, Path in, AtomicReference<Process> process)
            throws IOException, InterruptedException {
        process.set(new ProcessBuilder(command).directory(in.toFile()).inheritIO().start());
        return process.get().waitFor();
    }

    private static void end(Process process, Path scratch) {
        try {
            if (process != null) {
                process.destroy();
                if (!process.waitFor(LONGEST_END_S, TimeUnit.SECONDS)) {
                    process.destroyForcibly();
                }
            }
            delete(scratch);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } catch (IOException e) {
            System.err.println("[" + scratch + "] stays behind: " + e.getMessage());
        }
    }

    /** Deletes a folder with all that it contains. */
    private static void delete(Path folder) throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
                Files.deleteIfExists(file);
            }
        }
    }
}
