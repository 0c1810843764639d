package net.sf.jaer.chip;

/** Signatures of the class of that name in jAER that the filter needs; never run, never shipped. */
public class AEChip {
    public int getSizeX() {
        throw new UnsupportedOperationException();
    }

    public void setSizeX(int sizeX) {
        throw new UnsupportedOperationException();
    }

    public void setSizeY(int sizeY) {
        throw new UnsupportedOperationException();
    }

    public int getSizeY() {
        throw new UnsupportedOperationException();
    }
}
