package net.sf.jaer.event;

import java.util.Iterator;

/** As much of the class of that name in jAER as the tests of the filter need. */
public class ApsDvsEventPacket<E extends ApsDvsEvent> extends EventPacket<E> {
    @Override
    public Iterator<E> iterator() {
        return events.stream().filter(event -> !event.isFilteredOut() && event.isDVSEvent()).iterator();
    }

    public Iterator<E> fullIterator() {
        return super.iterator();
    }
}
