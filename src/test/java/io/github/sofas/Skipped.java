package io.github.sofas;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.AssumptionViolatedException;

/** Skips a test and says why, in a form that the build prints beside its name. */
public final class Skipped {
    private Skipped() {
    }

    /** Skips the test that calls it; always throws. */
    public static AssumptionViolatedException because(String reason) {
        System.out.println("skipped: " + reason);
        throw new AssumptionViolatedException(reason);
    }

    /** A real recording of the folder beside the project; skips the test where it is absent. */
    public static Path unlessRecorded(String name) {
        Path file = Path.of("..", "shared", "recordings", name);
        if (!Files.exists(file)) {
            throw because("there is no " + file);
        }
        return file;
    }
}
