package net.sf.jaer.event.orientation;

import net.sf.jaer.event.ApsDvsEvent;

/** As much of the class of that name in jAER as the tests of the filter need. */
public class ApsDvsOrientationEvent extends ApsDvsEvent {
}
