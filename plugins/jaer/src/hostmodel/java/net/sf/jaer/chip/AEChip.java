package net.sf.jaer.chip;

/** As much of the class of that name in jAER as the tests of the filter need. */
public class AEChip {
    public int sizeX;
    public int sizeY;

    public int getSizeX() {
        return sizeX;
    }

    public int getSizeY() {
        return sizeY;
    }
}
