package io.github.sofas;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;

/**
 * Programs in Python, for what other people's readers say of our files. Libraries come from PyPI into {@code
 * build/python}, once; where there is no Python or no PyPI the test is skipped and says why.
 */
public final class Python {
    private static final Path LIBRARIES = Path.of("build", "python").toAbsolutePath();
    private static final String PYTHON = System.getenv().getOrDefault("SOFAS_PYTHON", "python3");

    private Python() {
    }

    /**
     * Runs a program and returns what it prints.
     *
     * @param folder where it runs
     * @param libraries that it imports, by the names that PyPI has them under
     */
    public static synchronized String run(Path folder, String program, String... libraries)
            throws IOException, InterruptedException {
        String imports = "import " + String.join(", ", libraries);
        if (execute(folder, 60, List.of(PYTHON, "-c", imports)) == null) {
            install(folder, libraries);
            if (execute(folder, 60, List.of(PYTHON, "-c", imports)) == null) {
                throw Skipped.because("Python does not import " + String.join(", ", libraries) + " from PyPI");
            }
        }
        Path file = Files.writeString(folder.resolve("program.py"), program);
        Process process = start(folder, List.of(PYTHON, file.toString()));
        String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        if (process.waitFor() != 0) {
            throw new AssertionError(output);
        }
        return output;
    }

    private static void install(Path folder, String... libraries) throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(List.of(PYTHON, "-m", "pip", "install", "-q", "--target",
            LIBRARIES.toString(), "--upgrade"));
        command.addAll(List.of(libraries));
        execute(folder, 240, command);
    }

    /** What a command printed; null where it failed, is not there, or took too long. */
    private static String execute(Path folder, int seconds, List<String> command)
            throws IOException, InterruptedException {
        Process process;
        try {
            process = start(folder, command);
        } catch (IOException e) {
            throw Skipped.because("there is no " + PYTHON);
        }
        if (!process.waitFor(seconds, TimeUnit.SECONDS)) {
            process.destroyForcibly().waitFor();
            return null;
        }
        return process.exitValue() == 0 ? "" : null;
    }

    private static Process start(Path folder, List<String> command) throws IOException {
        ProcessBuilder builder = new ProcessBuilder(command).directory(folder.toFile()).redirectErrorStream(true);
        builder.environment().put("PYTHONPATH", LIBRARIES.toString());
        builder.environment().put("PYTHONIOENCODING", "utf-8");
        if (command.contains("pip")) {
            builder.redirectOutput(ProcessBuilder.Redirect.DISCARD);
        }
        return builder.start();
    }
}
