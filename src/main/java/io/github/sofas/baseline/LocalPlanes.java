package io.github.sofas.baseline;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.EventLabeller;
import io.github.sofas.flow.FlowOutput;
import java.util.Arrays;

/**
 * Local plane fitting (Benosman et al., "Event-based visual flow", IEEE Transactions on Neural Networks and Learning
 * Systems 25, 2014) in the robust variant of Rueckauer and Delbruck 2016.
 *
 * <p>A moving edge draws a surface t(x, y), the time of the last event at each pixel, by polarity. To the pixels of the
 * 7 x 7 window around an event that had one in the last {@link #MAX_AGE_US}, a plane a x + b y + c t + d = 0 is fitted
 * by total least squares; points farther from it than {@link #MAX_DISTANCE} are dropped and the plane fitted again
 * until none is dropped or the plane moves less than {@link #MIN_MOVE}. Its slope g = -(a, b) / c is the inverse of the
 * velocity across the edge: v = g / |g|² = -c (a, b) / (a² + b²). There is no flow from fewer than four points, nor
 * where |a| and |b| are both below {@link #MIN_SLOPE}, which means absurd speed. An event that follows another of its
 * pixel and polarity within {@link #REFRACTORY_US} is the same edge's echo: it gets no flow and does not move the
 * surface.
 *
 * <p>What is measured is the flow across the edge, |v| cos of the angle between edge normal and motion: right where an
 * edge moves straight ahead, by design too slow and turned elsewhere.
 *
 * <p>Differs from jAER's LocalPlanesFlow: points are relative to the event, where jAER takes x and y from the sensor's
 * corner and t from the packet's start, so that the bounds on the unit vector mean the same everywhere; the event's own
 * point is always in the fit; speed control, which drops speeds above twice their running mean, is left out.
 */
public final class LocalPlanes implements EventLabeller {
    /** Pixels from the middle of the window to its side: 7 x 7, as Lucas-Kanade's; jAER's default is 5 x 5. */
    public static final int WINDOW_RADIUS = 3;
    /** Older events are no part of the surface, in µs. jAER's default. */
    public static final long MAX_AGE_US = 50_000;
    /** An event so soon after another of its pixel and polarity gets no flow, in µs. jAER's default. */
    public static final long REFRACTORY_US = 50_000;
    /** Least change of the unit vector (a, b, c, d) that is worth another fit. jAER's th1. */
    public static final double MIN_MOVE = 1e-5;
    /** Greatest |a x + b y + c t + d| of a point that stays. jAER's th2. */
    public static final double MAX_DISTANCE = 4e-3;
    /** Least |a| or |b| of a plane that is taken for motion. jAER's th3. */
    public static final double MIN_SLOPE = 3e-3;

    private static final int MIN_POINTS = 4;
    private static final long NEVER = Long.MIN_VALUE;

    private final SensorSize sensor;
    private final long[] lastTimeUs;
    private final PlaneFit fit = new PlaneFit((2 * WINDOW_RADIUS + 1) * (2 * WINDOW_RADIUS + 1));
    private double vx;
    private double vy;

    /**
     * Makes one.
     *
     * @param sensor size of the sensor
     */
    public LocalPlanes(SensorSize sensor) {
        this.sensor = sensor;
        lastTimeUs = new long[2 * sensor.width() * sensor.height()];
        reset();
    }

    @Override
    public void process(EventBatch batch, FlowOutput output) {
        int size = batch.size();
        Labels.checkCapacity(size, output);
        int width = sensor.width();
        int pixels = width * sensor.height();
        for (int i = 0; i < size; i++) {
            int x = batch.x[i];
            int y = batch.y[i];
            long timeUs = batch.timeUs[i];
            Labels.set(output, i, 0, 0);
            if (!sensor.contains(x, y)) {
                continue;
            }
            int cell = (batch.polarity[i] > 0 ? pixels : 0) + y * width + x;
            long before = lastTimeUs[cell];
            if (before != NEVER && timeUs - before < REFRACTORY_US) {
                continue;
            }
            lastTimeUs[cell] = timeUs;
            if (x >= WINDOW_RADIUS && y >= WINDOW_RADIUS && x < width - WINDOW_RADIUS
                    && y < sensor.height() - WINDOW_RADIUS) {
                estimate(cell, timeUs);
                Labels.set(output, i, vx, vy);
            }
        }
    }

    @Override
    public void reset() {
        Arrays.fill(lastTimeUs, NEVER);
    }

    private void estimate(int centre, long timeUs) {
        vx = 0;
        vy = 0;
        fit.clear();
        for (int dy = -WINDOW_RADIUS; dy <= WINDOW_RADIUS; dy++) {
            int cell = centre + dy * sensor.width() - WINDOW_RADIUS;
            for (int dx = -WINDOW_RADIUS; dx <= WINDOW_RADIUS; dx++, cell++) {
                long last = lastTimeUs[cell];
                if (last != NEVER && timeUs - last < MAX_AGE_US) {
                    fit.add(dx, dy, (last - timeUs) * 1e-6);
                }
            }
        }
        if (fit.size() < MIN_POINTS) {
            return;
        }
        fit.fit();
        double move = Double.MAX_VALUE;
        while (move > MIN_MOVE && fit.dropFartherThan(MAX_DISTANCE)) {
            if (fit.size() < MIN_POINTS) {
                return;
            }
            move = fit.fit();
        }
        double[] plane = fit.plane();
        if (Math.abs(plane[0]) >= MIN_SLOPE || Math.abs(plane[1]) >= MIN_SLOPE) {
            double scale = -plane[2] / (plane[0] * plane[0] + plane[1] * plane[1]);
            vx = plane[0] * scale;
            vy = plane[1] * scale;
        }
    }
}
