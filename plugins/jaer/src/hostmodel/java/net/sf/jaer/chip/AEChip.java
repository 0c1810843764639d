package net.sf.jaer.chip;

import net.sf.jaer.graphics.AEViewer;

/** As much of the class of that name in jAER as the tests of the filter need. */
public class AEChip {
    public int sizeX;
    public int sizeY;
    public AEViewer viewer;

    public AEViewer getAeViewer() {
        return viewer;
    }

    public int getSizeX() {
        return sizeX;
    }

    public int getSizeY() {
        return sizeY;
    }
}
