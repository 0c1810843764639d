package net.sf.jaer.graphics;

import net.sf.jaer.eventio.AEFileInputStreamInterface;

/** As much of the class of that name in jAER as the tests of the filter need. */
public class AbstractAEPlayer {
    public AEFileInputStreamInterface in;

    public AEFileInputStreamInterface getAEInputStream() {
        return in;
    }
}
