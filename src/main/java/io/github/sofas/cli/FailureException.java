package io.github.sofas.cli;

/** A valid command cannot be carried out here, in contrast to wrong usage; the message is for the user. */
final class FailureException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    FailureException(String message, Throwable cause) {
        super(message, cause);
    }
}
