package net.sf.jaer.eventio;

import java.beans.PropertyChangeSupport;

/** As much of the class of that name in jAER as the tests of the filter need. */
public interface AEFileInputStreamInterface {
    PropertyChangeSupport getSupport();
}
