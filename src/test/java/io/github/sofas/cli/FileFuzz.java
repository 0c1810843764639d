package io.github.sofas.cli;

import io.github.sofas.FuzzRules;
import io.github.sofas.live.Biases;
import io.github.sofas.live.CameraModel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;

/** Small files that commands read beside recordings. Each class inside is a fuzz target. */
public final class FileFuzz {
    private static final Path FILE = FuzzRules.file(".file");

    private FileFuzz() {
    }

    /** What {@code live --biases} takes; the length chooses the camera. */
    public static final class BiasesFile {
        private BiasesFile() {
        }

        /** Called by the fuzzer. */
        public static void fuzzerTestOneInput(byte[] data) {
            FuzzRules.write(FILE, data);
            CameraModel[] models = CameraModel.values();
            Biases defaults = Biases.defaults(models[data.length % models.length]);
            try {
                Biases changed = LiveCommand.changed(defaults, ConfigFile.read(FILE));
                FuzzRules.require(changed.names().equals(defaults.names()),
                    "not all biases are there: " + changed.names());
            } catch (IllegalArgumentException e) {
                FuzzRules.require(e.getMessage().startsWith("[" + FILE.getFileName() + "] "),
                    "a message does not name the file: " + e.getMessage());
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
            FuzzRules.write(FILE, data);
            EarlierRun.of(FILE);
        }

        /** Valid inputs to start from. */
        public static List<byte[]> seeds() {
            return List.of("{'version': '1', 'request': 'a\\u0001b', 'recording': {'complete': true, 'n': 1e9}}"
                .replace('\'', '"').getBytes(StandardCharsets.UTF_8));
        }
    }
}
