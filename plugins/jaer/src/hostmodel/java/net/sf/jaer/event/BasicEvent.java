package net.sf.jaer.event;

/** As much of the class of that name in jAER as the tests of the filter need. */
public class BasicEvent {
    public int timestamp;
    public short x;
    public short y;
    public boolean special;
    public boolean filteredOut;

    public boolean isSpecial() {
        return special;
    }

    public boolean isFilteredOut() {
        return filteredOut;
    }

    public void copyFrom(BasicEvent e) {
        timestamp = e.timestamp;
        x = e.x;
        y = e.y;
    }
}
