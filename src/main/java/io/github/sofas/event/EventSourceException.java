package io.github.sofas.event;

/** Signals that an event source has failed. The message names the place, the broken rule and the value found. */
public class EventSourceException extends Exception {
    private static final long serialVersionUID = 1L;

    /**
     * Makes an exception without a cause.
     *
     * @param message what is wrong, for the user
     */
    public EventSourceException(String message) {
        super(message);
    }

    /**
     * Makes an exception with its cause.
     *
     * @param message what is wrong, for the user
     * @param cause the exception that led to this one
     */
    public EventSourceException(String message, Throwable cause) {
        super(message, cause);
    }
}
