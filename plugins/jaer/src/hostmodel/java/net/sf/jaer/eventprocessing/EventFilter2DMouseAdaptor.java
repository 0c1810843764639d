package net.sf.jaer.eventprocessing;

import net.sf.jaer.chip.AEChip;
import net.sf.jaer.graphics.FrameAnnotater;

/** As much of the class of that name in jAER as the tests of the filter need. */
public abstract class EventFilter2DMouseAdaptor extends EventFilter2D implements FrameAnnotater {
    public EventFilter2DMouseAdaptor(AEChip chip) {
        super(chip);
    }
}
