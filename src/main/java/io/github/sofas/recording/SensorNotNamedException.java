package io.github.sofas.recording;

import io.github.sofas.event.EventSourceException;

/** Neither the recording nor the caller names the sensor. */
public final class SensorNotNamedException extends EventSourceException {
    private static final long serialVersionUID = 1L;

    /** Whether a size is enough. */
    private final boolean takesSize;

    SensorNotNamedException(String message, boolean takesSize) {
        super(message);
        this.takesSize = takesSize;
    }

    /** {@return whether a size is enough, because the recording holds plain coordinates} */
    public boolean takesSize() {
        return takesSize;
    }

    /** Returns the same exception with more text in its message. */
    SensorNotNamedException with(String more) {
        return new SensorNotNamedException(getMessage() + more, takesSize);
    }
}
