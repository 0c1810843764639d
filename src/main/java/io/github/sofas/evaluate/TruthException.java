package io.github.sofas.evaluate;

/** A truth file cannot be used. The message names the file, the line, the rule that was broken and the value found. */
public final class TruthException extends Exception {
    private static final long serialVersionUID = 1L;

    TruthException(String message) {
        super(message);
    }
}
