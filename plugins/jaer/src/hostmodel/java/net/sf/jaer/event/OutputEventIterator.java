package net.sf.jaer.event;

/** As much of the class of that name in jAER as the tests of the filter need. */
public interface OutputEventIterator<E extends BasicEvent> {
    E nextOutput();
}
