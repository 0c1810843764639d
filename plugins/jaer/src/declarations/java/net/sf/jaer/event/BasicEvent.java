package net.sf.jaer.event;

/** Signatures of the class of that name in jAER that the filter needs; never run, never shipped. */
public class BasicEvent {
    public int timestamp;
    public short x;
    public short y;

    public boolean isSpecial() {
        throw new UnsupportedOperationException();
    }

    public boolean isFilteredOut() {
        throw new UnsupportedOperationException();
    }

    public void copyFrom(BasicEvent e) {
        throw new UnsupportedOperationException();
    }
}
