package net.sf.jaer.graphics;

/** As much of the class of that name in jAER as the tests of the filter need. */
public class AEViewer {
    public static final String EVENT_TIMESTAMPS_RESET = "timestampsReset";

    public final AbstractAEPlayer player = new AbstractAEPlayer();

    public AbstractAEPlayer getAePlayer() {
        return player;
    }
}
