package net.sf.jaer.event;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;

/** As much of the class of that name in jAER as the tests of the filter need. */
public class EventPacket<E extends BasicEvent> implements Iterable<E> {
    public final List<E> events = new ArrayList<>();

    @Override
    public Iterator<E> iterator() {
        return events.stream().filter(event -> !event.isFilteredOut()).iterator();
    }
}
