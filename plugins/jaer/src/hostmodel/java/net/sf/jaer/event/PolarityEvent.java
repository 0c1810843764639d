package net.sf.jaer.event;

/** As much of the class of that name in jAER as the tests of the filter need. */
public class PolarityEvent extends TypedEvent {
    public Polarity polarity = Polarity.On;

    public enum Polarity {
        On, Off
    }

    @Override
    public void copyFrom(BasicEvent e) {
        super.copyFrom(e);
        polarity = ((PolarityEvent) e).polarity;
    }
}
