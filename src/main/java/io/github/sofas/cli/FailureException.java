package io.github.sofas.cli;

/** What was asked makes sense but cannot be done here; the message is for the user. */
final class FailureException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    FailureException(String message, Throwable cause) {
        super(message, cause);
    }
}
