package io.github.sofas.live;

/** A USB operation has failed. */
public final class UsbException extends Exception {
    private static final long serialVersionUID = 1L;

    /** What kind of fault it is. */
    private final Fault fault;

    /** What is wrong, as far as it makes a difference to the user. */
    public enum Fault {
        /** The system does not let this user open the device. */
        NO_PERMISSION,
        /** Another program has the device. */
        BUSY,
        /** The device is no longer there. */
        GONE,
        /** Anything else. */
        OTHER
    }

    /**
     * Makes one.
     *
     * @param fault what kind of fault it is
     * @param message what is wrong, for the user
     */
    public UsbException(Fault fault, String message) {
        super(message);
        this.fault = fault;
    }

    /**
     * Makes one with its cause.
     *
     * @param fault what kind of fault it is
     * @param message what is wrong, for the user
     * @param cause what it came from
     */
    public UsbException(Fault fault, String message, Throwable cause) {
        super(message, cause);
        this.fault = fault;
    }

    /** {@return what is wrong} */
    public Fault fault() {
        return fault;
    }
}
