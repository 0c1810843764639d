package net.sf.jaer.eventprocessing;

import java.beans.PropertyChangeListener;
import net.sf.jaer.chip.AEChip;
import net.sf.jaer.event.BasicEvent;
import net.sf.jaer.event.EventPacket;

/** As much of the class of that name in jAER as the tests of the filter need. */
public abstract class EventFilter2D extends EventFilter implements PropertyChangeListener {
    public EventFilter2D(AEChip chip) {
        super(chip);
    }

    public abstract EventPacket<? extends BasicEvent> filterPacket(EventPacket<? extends BasicEvent> in);
}
