package net.sf.jaer.event;

/** Signatures of the class of that name in jAER that the filter needs; never run, never shipped. */
public interface OutputEventIterator<E extends BasicEvent> {
    E nextOutput();
}
