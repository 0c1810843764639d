package io.github.sofas.jaer;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.atomic.AtomicReference;

/**
 * Starts {@link ServeFilter} with the jAER in a folder, on the standard input and output of this process. Its arguments
 * are {@code JAER_FOLDER FILTER WIDTH HEIGHT}. This is a program of its own, because it runs without jAER's classes.
 */
public final class StartFilter {
    private StartFilter() {
    }

    /** Ends with the exit code of the other process, or with 1 and a message if that process cannot be started. */
    public static void main(String[] arguments) throws InterruptedException {
        try {
            System.exit(start(Path.of(arguments[0]), Arrays.asList(arguments).subList(1, arguments.length)));
        } catch (IOException e) {
            System.err.println(e.getMessage());
            System.exit(1);
        }
    }

    private static int start(Path folder, List<String> arguments) throws IOException, InterruptedException {
        JaerFolder jaer = JaerFolder.of(folder);
        Path scratch = Files.createTempDirectory("sofas-compare");
        AtomicReference<Process> process = StartJaer.endedWithThis(scratch);
        // uses neither the user's settings nor the traces of other viewers
        List<String> options = List.of("-Djava.util.prefs.userRoot=" + scratch, "-Djava.io.tmpdir=" + scratch);
        List<String> command = new ArrayList<>(jaer.command(scratch, options, "io.github.sofas.jaer.ServeFilter"));
        command.addAll(arguments);
        return StartJaer.run(command, scratch, process);
    }
}
