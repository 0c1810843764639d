package net.sf.jaer.event;

/** Signatures of the class of that name in jAER that the filter needs; never run, never shipped. */
public class ApsDvsEvent extends PolarityEvent {
    public boolean isImuSample() {
        throw new UnsupportedOperationException();
    }

    public boolean isDVSEvent() {
        throw new UnsupportedOperationException();
    }
}
