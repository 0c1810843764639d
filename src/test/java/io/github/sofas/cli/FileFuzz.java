package io.github.sofas.cli;

import io.github.sofas.live.Biases;
import io.github.sofas.live.CameraModel;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** Small files that commands read beside recordings. Each class inside is a fuzz target. */
public final class FileFuzz {
    private static final Path FILE = file();

    private FileFuzz() {
    }

    private static Path file() {
        try {
            Path file = Files.createTempFile("sofas-fuzz", ".file");
            file.toFile().deleteOnExit();
            return file;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static void write(byte[] data) {
        try {
            Files.write(FILE, data);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** What {@code live --biases} takes; the length chooses the camera. */
    public static final class BiasesFile {
        private BiasesFile() {
        }

        /** Called by the fuzzer. */
        public static void fuzzerTestOneInput(byte[] data) {
            write(data);
            CameraModel[] models = CameraModel.values();
            Biases defaults = Biases.defaults(models[data.length % models.length]);
            try {
                Biases changed = LiveCommand.changed(defaults, ConfigFile.read(FILE));
                if (!changed.names().equals(defaults.names())) {
                    throw new IllegalStateException("not all biases are there: " + changed.names());
                }
            } catch (IllegalArgumentException e) {
                if (!e.getMessage().startsWith("[" + FILE.getFileName() + "] ")) {
                    throw new IllegalStateException("a message does not name the file: " + e.getMessage());
                }
            }
        }

        /** Valid inputs to start from. */
        public static List<byte[]> seeds() {
            return List.of("DiffBn = 0x427F\nOnBn=4 39\n# slower\nPrBp: 100\n".getBytes(StandardCharsets.UTF_8),
                "diffOn=209996\ndiff 0x10\nPR=0\n\n".getBytes(StandardCharsets.UTF_8));
        }
    }

    /** Summaries of earlier runs, which {@code run --resume} looks at. */
    public static final class EarlierSummary {
        private EarlierSummary() {
        }

        /** Called by the fuzzer. */
        public static void fuzzerTestOneInput(byte[] data) {
            write(data);
            EarlierRun.of(FILE);
        }

        /** Valid inputs to start from. */
        public static List<byte[]> seeds() {
            return List.of("{'version': '1', 'request': 'a\\u0001b', 'recording': {'complete': true, 'n': 1e9}}"
                .replace('\'', '"').getBytes(StandardCharsets.UTF_8));
        }
    }
}
