package net.sf.jaer.event;

import java.util.Iterator;

/** Signatures of the class of that name in jAER that the filter needs; never run, never shipped. */
public class ApsDvsEventPacket<E extends ApsDvsEvent> extends EventPacket<E> {
    public ApsDvsEventPacket(Class<? extends ApsDvsEvent> eventClass) {
        super(eventClass);
    }

    public Iterator<E> fullIterator() {
        throw new UnsupportedOperationException();
    }
}
