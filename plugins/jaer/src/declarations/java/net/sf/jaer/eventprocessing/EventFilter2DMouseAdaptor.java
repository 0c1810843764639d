package net.sf.jaer.eventprocessing;

import net.sf.jaer.chip.AEChip;
import net.sf.jaer.graphics.FrameAnnotater;

/** Signatures of the class of that name in jAER that the filter needs; never run, never shipped. */
public abstract class EventFilter2DMouseAdaptor extends EventFilter2D implements FrameAnnotater {
    public EventFilter2DMouseAdaptor(AEChip chip) {
        super(chip);
    }
}
