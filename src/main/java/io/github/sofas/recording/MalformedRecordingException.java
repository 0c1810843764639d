package io.github.sofas.recording;

import io.github.sofas.event.EventSourceException;

/**
 * A recording is damaged, or holds what is not served. The message names file, event and byte, then one of three words:
 * <i>truncated</i> (the file ends too early), <i>malformed</i> (a value that no recorder may write) or
 * <i>unsupported</i> (may be right, but is not served here), then the rule and the value found.
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
