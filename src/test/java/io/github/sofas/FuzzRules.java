package io.github.sofas;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** What fuzz targets have in common: a file that the input is written to, and rules that hold for every message. */
public final class FuzzRules {
    private FuzzRules() {
    }

    /** An empty file of its own, which goes with the program. */
    public static Path file(String ending) {
        try {
            Path file = Files.createTempFile("sofas-fuzz", ending);
            file.toFile().deleteOnExit();
            return file;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Puts an input into a file. */
    public static void write(Path file, byte[] input) {
        try {
            Files.write(file, input);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Holds a message for the user against the place that it begins with and the length that it must not pass. */
    public static void checkMessage(String message, String place, int longest) {
        require(message.startsWith(place), "a message does not begin with " + place + ": " + message);
        require(message.length() <= longest, "a message is too long: " + message.length());
        require(message.chars().noneMatch(Character::isISOControl), "a message holds control characters");
    }

    /** Holds a rule. */
    public static void require(boolean holds, String otherwise) {
        if (!holds) {
            throw new IllegalStateException(otherwise);
        }
    }
}
