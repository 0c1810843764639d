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
 * <p>A moving edge leaves a surface t(x, y), the time of the last event at each pixel, for each polarity. The points of
 * an event are the pixels of the 7 x 7 window around it that had an event in the last {@link #MAX_AGE_US}. A plane
 * a x + b y + c t + d = 0 is fitted to these points by total least squares. Points farther from the plane than
 * {@link #MAX_DISTANCE} are dropped and the plane is fitted again, until no point is dropped or the plane moves by less
 * than {@link #MIN_MOVE}. The slope of the plane, g = -(a, b) / c, is the inverse of the velocity across the edge:
 * v = g / |g|² = -c (a, b) / (a² + b²).
 *
 * <p>There is no flow from fewer than four points, nor if |a| and |b| are both below {@link #MIN_SLOPE}, which means an
 * absurd speed. An event that follows the surface's event of its pixel and polarity within {@link #REFRACTORY_US} is an
 * echo of the same edge. It gets no flow and does not change the surface.
 *
 * <p>The method measures the flow across the edge, |v| times the cosine of the angle between edge normal and motion.
 * This is correct if an edge moves along its normal. Otherwise the flow is, by design, too slow and turned.
 *
 * <p>Differences from jAER's LocalPlanesFlow:
 * <ul>
 * <li>Points are relative to the event, so that the bounds on the unit vector mean the same everywhere. jAER takes x
 *     and y from the sensor's corner and t from the packet's start.
 * <li>The event's own point is always in the fit.
 * <li>Speed control, which drops speeds above twice their running mean, is left out.
 * </ul>
 */
public final class LocalPlanes implements EventLabeller {
    /** Pixels from the centre of the window to its side: 7 x 7, as for Lucas-Kanade. jAER's default is 5 x 5. */
    public static final int WINDOW_RADIUS = 3;
    /** Age in µs from which events are no longer part of the surface. jAER's default. */
    public static final long MAX_AGE_US = 50_000;
    /** Time in µs after an event within which its pixel and polarity get no flow. jAER's default. */
    public static final long REFRACTORY_US = 50_000;
    /** Smallest change of the unit vector (a, b, c, d) that is worth another fit. jAER's th1. */
    public static final double MIN_MOVE = 1e-5;
    /** Greatest |a x + b y + c t + d| of a point that stays in the fit. jAER's th2. */
    public static final double MAX_DISTANCE = 4e-3;
    /** Smallest |a| or |b| of a plane that is accepted as motion. jAER's th3. */
    public static final double MIN_SLOPE = 3e-3;

    private static final int MIN_POINTS = 4;
    private static final long NEVER = Long.MIN_VALUE;

    private final SensorSize sensor;
    private final long[] lastTimeUs;
    private final PlaneFit fit = new PlaneFit((2 * WINDOW_RADIUS + 1) * (2 * WINDOW_RADIUS + 1));
    private double vx;
    private double vy;

    /**
     * Makes one for a sensor.
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
