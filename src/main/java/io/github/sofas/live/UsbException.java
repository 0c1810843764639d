package io.github.sofas.live;

/** A USB operation has failed. The {@link Fault} distinguishes the cases that need different action by the user. */
public final class UsbException extends Exception {
    private static final long serialVersionUID = 1L;

    /** Kind of fault. */
    private final Fault fault;

    /** Kinds of faults, distinguished as far as the difference matters to the user. */
    public enum Fault {
        /** The operating system does not allow this user to open the device. */
        NO_PERMISSION,
        /** Another program uses the device. */
        BUSY,
        /** The device is no longer there. */
        GONE,
        /** Anything else. */
        OTHER
    }

    /**
     * Makes an exception without a cause.
     *
     * @param fault kind of fault
     * @param message what is wrong, for the user
     */
    public UsbException(Fault fault, String message) {
        super(message);
        this.fault = fault;
    }

    /**
     * Makes an exception with a cause.
     *
     * @param fault kind of fault
     * @param message what is wrong, for the user
     * @param cause exception that led to this one
     */
    public UsbException(Fault fault, String message, Throwable cause) {
        super(message, cause);
        this.fault = fault;
    }

    /** {@return the kind of fault} */
    public Fault fault() {
        return fault;
    }
}
