package io.github.sofas.recording;

import io.github.sofas.event.EventSourceException;

/**
 * A recording is damaged, or holds something that is not supported. The message names file, event and byte, then one of
 * three words, then the rule and the value found. The words are <i>truncated</i> (the file ends too early),
 * <i>malformed</i> (a value that no recorder may write) and <i>unsupported</i> (possibly right, but not supported
 * here).
 */
public final class MalformedRecordingException extends EventSourceException {
    private static final long serialVersionUID = 1L;

    MalformedRecordingException(String message) {
        super(message);
    }

    MalformedRecordingException(String message, Throwable cause) {
        super(message, cause);
    }
}
