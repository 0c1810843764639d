package io.github.sofas.evaluate;

/** A truth file cannot be used; the message names the file, the line, the rule that was broken and what was found. */
public final class TruthException extends Exception {
    private static final long serialVersionUID = 1L;

    TruthException(String message) {
        super(message);
    }
}
