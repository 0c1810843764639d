package net.sf.jaer.graphics;

import net.sf.jaer.eventio.AEFileInputStreamInterface;

/** Signatures of the class of that name in jAER that the filter needs; never run, never shipped. */
public abstract class AbstractAEPlayer {
    public AEFileInputStreamInterface getAEInputStream() {
        throw new UnsupportedOperationException();
    }
}
