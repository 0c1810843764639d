package net.sf.jaer.graphics;

/** Signatures of the class of that name in jAER that the filter needs; never run, never shipped. */
public class AEViewer {
    public static final String EVENT_TIMESTAMPS_RESET = "timestampsReset";

    public AbstractAEPlayer getAePlayer() {
        throw new UnsupportedOperationException();
    }
}
