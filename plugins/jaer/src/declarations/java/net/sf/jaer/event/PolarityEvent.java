package net.sf.jaer.event;

/** Signatures of the class of that name in jAER that the filter needs; never run, never shipped. */
public class PolarityEvent extends TypedEvent {
    public Polarity polarity;

    public enum Polarity {
        On, Off
    }
}
