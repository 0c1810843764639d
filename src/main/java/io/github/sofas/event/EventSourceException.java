package io.github.sofas.event;

/** An event source has failed; the message names the place, the rule that was broken and the value found. */
public class EventSourceException extends Exception {
    private static final long serialVersionUID = 1L;

    /**
     * Makes one without a cause.
     *
     * @param message what is wrong, for the user
     */
    public EventSourceException(String message) {
        super(message);
    }

    /**
     * Makes one with its cause.
     *
     * @param message what is wrong, for the user
     * @param cause what it came from
     */
    public EventSourceException(String message, Throwable cause) {
        super(message, cause);
    }
}
