package net.sf.jaer.eventio;

import java.beans.PropertyChangeSupport;

/** Signatures of the class of that name in jAER that the filter needs; never run, never shipped. */
public interface AEFileInputStreamInterface {
    PropertyChangeSupport getSupport();
}
