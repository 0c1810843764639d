package io.github.sofas.flow.motion;

import io.github.sofas.event.SensorSize;

/**
 * Estimates the rate of noise per pixel. Events count as noise that nothing explains and that are alone: events of a
 * structure that is not tracked yet seldom are.
 */
public final class NoiseRate {
    /** Time constant of the fading mean of the rate: noise changes with the light. */
    private static final double MEAN_US = 300_000;
    /** An event is alone if no pixel around it has fired within this time. */
    private static final double ALONE_US = 10_000;
    /** Pixels around an event, each with both polarities. */
    private static final int AROUND = 2 * 8;
    /** Least share of noise that is taken to be alone when the rate of all noise is inferred: noise hides noise. */
    private static final double LEAST_ALONE = 0.2;

    private final double pixels;
    private final LoneEvents unexplained;
    private int alone;
    private long sinceUs;
    private boolean started;
    private double alonePerUs;
    private double perUs;

    /** Makes an estimate that has seen no events yet. */
    public NoiseRate(SensorSize sensor) {
        // ON and OFF count separately
        pixels = 2.0 * sensor.width() * sensor.height();
        unexplained = new LoneEvents(sensor.width(), sensor.height(), 1e6 / ALONE_US);
    }

    /** Bytes that the array takes. */
    public static long bytes(SensorSize sensor) {
        return LoneEvents.bytes(sensor);
    }

    /** Notes an event that nothing explains. */
    public void note(int x, int y, long timeUs) {
        if (unexplained.isAlone(x, y, timeUs)) {
            alone++;
        }
    }

    /** Updates the rate with the events noted until a time. */
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

    /** Noise events per pixel and per µs, of each polarity. */
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
