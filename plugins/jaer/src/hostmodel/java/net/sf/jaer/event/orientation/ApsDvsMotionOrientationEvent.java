package net.sf.jaer.event.orientation;

import java.awt.geom.Point2D;

/** As much of the class of that name in jAER as the tests of the filter need. */
public class ApsDvsMotionOrientationEvent extends ApsDvsOrientationEvent {
    public boolean hasDirection;
    public Point2D.Float velocity;
}
