package io.github.sofas.host;

import java.io.IOException;

/** jAER cannot be started, or ended early. The message is for the user. */
public final class JaerException extends IOException {
    private static final long serialVersionUID = 1;

    JaerException(String message) {
        super(message);
    }
}
