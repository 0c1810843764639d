package io.github.sofas.cli;

import io.github.sofas.event.EventSourceException;
import java.io.IOException;
import java.nio.file.Path;

/** Explains to the user why a recording has no results. */
final class RunFailure {
    private RunFailure() {
    }

    /**
     * The message for the user; null if the program itself is at fault.
     *
     * @param recording the recording that was run
     * @param cause the exception that {@link RecordingRun#run} threw
     */
    static String text(Path recording, Throwable cause) {
        String place = "[" + recording.getFileName() + "] ";
        if (cause instanceof EventSourceException) {
            return cause.getMessage();
        } else if (cause instanceof IOException) {
            return place + "results cannot be written: " + FileFailure.text((IOException) cause);
        } else if (cause instanceof OutOfMemoryError) {
            return place + "out of memory: Java's heap has " + (Runtime.getRuntime().maxMemory() >> 20)
                + " MB; SOFAS_JAVA_OPTS=-Xmx4g would give it 4096";
        }
        return null;
    }
}
