package io.github.sofas.event;

/** An event source has failed; the message names the place, the rule that was broken and the value found. */
public class EventSourceException extends Exception {
    private static final long serialVersionUID = 1L;

    /** Makes one without a cause. */
    public EventSourceException(String message) {
        super(message);
    }

    /** Makes one with its cause. */
    public EventSourceException(String message, Throwable cause) {
        super(message, cause);
    }
}
