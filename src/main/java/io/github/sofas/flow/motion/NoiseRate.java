package io.github.sofas.flow.motion;

import io.github.sofas.event.SensorSize;

/**
 * How often a pixel gives noise: events that nothing explains and that are alone, as those of a structure that is not
 * tracked yet seldom are.
 */
public final class NoiseRate {
    /** Time of which it is a mean, fading: noise changes with the light. */
    private static final double MEAN_US = 300_000;
    /** An event is alone that has none around it within this time. */
    private static final double ALONE_US = 10_000;
    /** Pixels around it, each with both polarities. */
    private static final int AROUND = 2 * 8;
    /** Share that is alone at least, for the rest to be told from it: noise hides noise. */
    private static final double LEAST_ALONE = 0.2;

    private final double pixels;
    private final LoneEvents unexplained;
    private int alone;
    private long sinceUs;
    private boolean started;
    private double alonePerUs;
    private double perUs;

    /** Makes one that knows of no events yet. */
    public NoiseRate(SensorSize sensor) {
        // ON and OFF apart
        pixels = 2.0 * sensor.width() * sensor.height();
        unexplained = new LoneEvents(sensor.width(), sensor.height(), 1e6 / ALONE_US);
    }

    /** Bytes of its array. */
    public static long bytes(SensorSize sensor) {
        return LoneEvents.bytes(sensor);
    }

    /** Notes an event that nothing explains. */
    public void note(int x, int y, long timeUs) {
        if (unexplained.isAlone(x, y, timeUs)) {
            alone++;
        }
    }

    /** Goes on to a time. */
    public void goOn(long nowUs) {
        double us = nowUs - sinceUs;
        if (started && us > 0) {
            alonePerUs += (alone / (us * pixels) - alonePerUs) * us / (us + MEAN_US);
            perUs = alonePerUs / Math.max(LEAST_ALONE, 1 - AROUND * ALONE_US * alonePerUs);
        }
        started = true;
        sinceUs = nowUs;
        alone = 0;
    }

    /** How many noise events a pixel gives of either polarity, per µs. */
    public double perUs() {
        return perUs;
    }

    /** Forgets all events. */
    public void reset() {
        unexplained.reset();
        alone = 0;
        started = false;
        alonePerUs = 0;
        perUs = 0;
    }
}
