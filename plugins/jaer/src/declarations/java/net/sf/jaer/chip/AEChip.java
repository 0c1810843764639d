package net.sf.jaer.chip;

import net.sf.jaer.graphics.AEViewer;

/** Signatures of the class of that name in jAER that the filter needs; never run, never shipped. */
public class AEChip {
    public AEViewer getAeViewer() {
        throw new UnsupportedOperationException();
    }

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
