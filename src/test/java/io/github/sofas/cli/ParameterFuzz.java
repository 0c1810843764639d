package io.github.sofas.cli;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * Command lines and config files: whatever they say, they are refused in one message, or their parameters are taken.
 * The recording is not there, so that nothing is run.
 */
public final class ParameterFuzz {
    private static final Path CONFIG = config();

    private ParameterFuzz() {
    }

    private static Path config() {
        try {
            Path file = Files.createTempFile("sofas-fuzz", ".properties");
            file.toFile().deleteOnExit();
            return file;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Called by the fuzzer: a config file up to the first zero, then arguments between zeros. */
    public static void fuzzerTestOneInput(byte[] data) {
        String[] parts = new String(data, StandardCharsets.ISO_8859_1).split("\0", -1);
        List<String> arguments = new ArrayList<>(List.of("run", "no such recording", "--out", "no such folder"));
        try {
            Files.write(CONFIG, parts[0].getBytes(StandardCharsets.ISO_8859_1));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        if (!parts[0].isEmpty()) {
            arguments.addAll(List.of("--config", CONFIG.toString()));
        }
        for (int i = 1; i < parts.length; i++) {
            arguments.add(parts[i]);
        }
        Executed run = Executed.command(arguments.toArray(new String[0]));
        boolean asksForHelp = run.exitCode == 0 && !run.out.isEmpty();
        if (run.exitCode != 2 && !asksForHelp) {
            throw new IllegalStateException("exit code " + run.exitCode + ": " + run.err);
        }
        if (run.err.contains("unexpected error") || run.err.contains("\tat ")) {
            throw new IllegalStateException(run.err);
        }
        if (run.err.chars().anyMatch(c -> Character.isISOControl(c) && c != '\n')) {
            throw new IllegalStateException("a message holds control characters: " + run.err);
        }
    }

    /** Valid inputs to start from. */
    public static List<byte[]> seeds() {
        List<byte[]> seeds = new ArrayList<>();
        for (String text : List.of("lifetime-px=6\nmax-track-planes = 3\n# no more\nrotation: false\n", "",
            "merge-loss=1e-2\0--preset\0paper\0--cycles=2", "\0--lifetime-px\0" + 5 + "\0--max-lifetime-px\0" + 4,
            "\0--method\0lucas-kanade\0--derivative\0central-difference", "\0--chip\0DAVIS240C\0--strict\0-j\0" + 2,
            "flow\\u002dtravel-px=6", "\0--rotation\0true\0--quiet\0--force\0--name-with-extension")) {
            seeds.add(text.getBytes(StandardCharsets.ISO_8859_1));
        }
        return seeds;
    }
}
