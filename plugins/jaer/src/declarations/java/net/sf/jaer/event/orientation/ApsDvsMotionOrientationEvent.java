package net.sf.jaer.event.orientation;

import java.awt.geom.Point2D;

/** Signatures of the class of that name in jAER that the filter needs; never run, never shipped. */
public class ApsDvsMotionOrientationEvent extends ApsDvsOrientationEvent {
    public boolean hasDirection;
    public Point2D.Float velocity;
}
