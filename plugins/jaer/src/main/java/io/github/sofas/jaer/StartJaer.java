package io.github.sofas.jaer;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;

/** {@code java -jar sofas-jAER.jar DIR [RECORDING]}: starts the jAER in a folder, with the filter in its list. */
public final class StartJaer {
    private static final String USAGE = "usage: java -jar sofas-jAER.jar JAER_FOLDER [RECORDING]\n"
        + "Starts the jAER in a folder, with SOFAS among its filters.";

    private StartJaer() {
    }

    /** Ends with jAER's exit code, 1 where jAER cannot be started, 2 on wrong usage. */
    public static void main(String[] arguments) throws InterruptedException {
        if (arguments.length < 1 || arguments.length > 2 || arguments[0].startsWith("-")) {
            System.err.println(USAGE);
            System.exit(2);
        }
        try {
            System.exit(start(Path.of(arguments[0]), Arrays.asList(arguments).subList(1, arguments.length)));
        } catch (IOException e) {
            System.err.println(e.getMessage());
            System.exit(1);
        }
    }

    private static int start(Path folder, List<String> recordings) throws IOException, InterruptedException {
        JaerFolder jaer = JaerFolder.of(folder);
        for (String recording : recordings) {
            if (!Files.isReadable(Path.of(recording))) {
                throw new IOException("[" + recording + "] no such file, or not readable");
            }
        }
        Path overlay = Files.createTempDirectory("sofas-jaer");
        try {
            List<String> command = jaer.command(overlay, List.of(), "net.sf.jaer.JAERViewer");
            // jAER runs in its own folder
            recordings.forEach(recording -> command.add(Path.of(recording).toAbsolutePath().toString()));
            return run(command, jaer.folder());
        } finally {
            delete(overlay);
        }
    }

    /** Runs a command with input and output of this process, which takes it along when it ends; its exit code. */
    static int run(List<String> command, Path in) throws IOException, InterruptedException {
        Process process = new ProcessBuilder(command).directory(in.toFile()).inheritIO().start();
        Runtime.getRuntime().addShutdownHook(new Thread(process::destroy));
        return process.waitFor();
    }

    /** Deletes a folder with all that is in it. */
    static void delete(Path folder) throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
                Files.deleteIfExists(file);
            }
        }
    }
}
