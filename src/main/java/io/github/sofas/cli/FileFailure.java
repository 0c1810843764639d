package io.github.sofas.cli;

import io.github.sofas.recording.Printable;
import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.NoSuchFileException;

/**
 * Explains to the user why a file or a directory cannot be written. In the usual cases, Java's message is only the
 * path.
 */
final class FileFailure {
    private FileFailure() {
    }

    static String text(IOException exception) {
        IOException e = exception;
        // libraries wrap the system's exception
        while (e.getCause() instanceof IOException) {
            e = (IOException) e.getCause();
        }
        String reason = "";
        if (e instanceof NoSuchFileException) {
            reason = ": the directory is not there";
        } else if (e instanceof AccessDeniedException) {
            reason = ": no permission";
        } else if (e instanceof FileAlreadyExistsException) {
            reason = ": is a file and no directory";
        }
        return Printable.of(e.getMessage() == null ? e.toString() : e.getMessage() + reason);
    }
}
