package io.github.sofas.live;

/** A USB operation has failed. */
public final class UsbException extends Exception {
    private static final long serialVersionUID = 1L;

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

    /** Makes one. */
    public UsbException(Fault fault, String message) {
        super(message);
        this.fault = fault;
    }

    /** Makes one with its cause. */
    public UsbException(Fault fault, String message, Throwable cause) {
        super(message, cause);
        this.fault = fault;
    }

    /** What is wrong. */
    public Fault fault() {
        return fault;
    }
}
