package net.sf.jaer.event.orientation;

import net.sf.jaer.event.ApsDvsEvent;

/** Signatures of the class of that name in jAER that the filter needs; never run, never shipped. */
public class ApsDvsOrientationEvent extends ApsDvsEvent {
}
