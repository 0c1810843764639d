package net.sf.jaer.event;

import java.util.Iterator;

/** Signatures of the class of that name in jAER that the filter needs; never run, never shipped. */
public class EventPacket<E extends BasicEvent> implements Iterable<E> {
    public EventPacket(Class<? extends BasicEvent> eventClass) {
        throw new UnsupportedOperationException();
    }

    public OutputEventIterator<E> outputIterator() {
        throw new UnsupportedOperationException();
    }

    @Override
    public Iterator<E> iterator() {
        throw new UnsupportedOperationException();
    }
}
