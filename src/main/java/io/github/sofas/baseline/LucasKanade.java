package io.github.sofas.baseline;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.EventLabeller;
import io.github.sofas.flow.FlowOutput;

/**
 * Lucas-Kanade for events (Benosman et al., "Asynchronous frameless event-based optical flow", Neural Networks 27,
 * 2012) as implemented and improved by Rueckauer and Delbruck 2016.
 *
 * <p>Let n(x, y) be the number of events of the event's polarity at a pixel in the last {@link #MAX_AGE_US}, and T that
 * age. The method takes n for the brightness and n / T for its change in time. Over the window W of 7 x 7 pixels around
 * the event, it solves the least-squares problem
 * <pre>
 *   minimise over v   sum over W of (nx vx + ny vy + n / T)²
 * </pre>
 * where nx and ny are differences of n ({@link Derivative}). Let l1 &gt;= l2 be the eigenvalues of the sum over W of
 * the products of (nx, ny). There is no flow if l1 &lt; 1. If only l2 &lt; 1, the flow is the normal flow at the centre
 * pixel, v = -(nx, ny) n / (T |(nx, ny)|²). Otherwise the flow is the least-squares solution.
 *
 * <p>Counts are not brightness: they rise while an edge approaches, but fall only by age. The flow is therefore too
 * slow, by 80 % with central differences and by 20 to 40 % with {@link Derivative#SAVITZKY_GOLAY}.
 *
 * <p>As in jAER, {@link Derivative#SAVITZKY_GOLAY} divides the change in time by the window's radius, a calibration
 * without a derivation. Differences from jAER's LucasKanadeFlow:
 * <ul>
 * <li>Events near the border are counted, though not labelled.
 * <li>T is the true age. jAER writes 1 / T = 20 / s for every age, which is the same at its default age.
 * <li>Speed control, which drops speeds above twice their running mean, and the shift of time over gaps are left out.
 * </ul>
 */
public final class LucasKanade implements EventLabeller {
    /** Pixels from the centre of the window to its side: 7 x 7. jAER's default. */
    public static final int WINDOW_RADIUS = 3;
    /** Age in µs above which events are not counted. jAER's default. */
    public static final long MAX_AGE_US = 50_000;
    /** Smallest eigenvalue that shows a gradient, in squared differences summed over the window. jAER's default. */
    public static final double MIN_EIGENVALUE = 1;

    private static final int WINDOW = (2 * WINDOW_RADIUS + 1) * (2 * WINDOW_RADIUS + 1);

    /** How counts are differentiated. The bound on the eigenvalues refers to the differences as given here. */
    public enum Derivative {
        /** n(x) - n(x - 1): the original method, which is biased to the left and up. */
        BACKWARD_DIFFERENCE(1),
        /** n(x + 1) - n(x - 1), compared with twice the change in time. jAER's default. */
        CENTRAL_DIFFERENCE(1),
        /** The slope of the plane fitted to n over the window, the first-order Savitzky-Golay filter. */
        SAVITZKY_GOLAY(0);

        private final int reach;

        Derivative(int reach) {
            this.reach = reach;
        }
    }

    private final SensorSize sensor;
    private final Derivative derivative;
    private final int margin;
    private final EventCounts counts;
    private double vx;
    private double vy;

    /**
     * Makes one with {@link Derivative#SAVITZKY_GOLAY}, the best of the three. It underestimates magnitudes by 21 to
     * 30 %; the SOFAS paper found 35 % for Lucas-Kanade.
     *
     * @param sensor size of the sensor
     */
    public LucasKanade(SensorSize sensor) {
        this(sensor, Derivative.SAVITZKY_GOLAY);
    }

    /**
     * Makes one with a given derivative.
     *
     * @param sensor size of the sensor
     * @param derivative how counts are differentiated
     */
    public LucasKanade(SensorSize sensor, Derivative derivative) {
        this.sensor = sensor;
        this.derivative = derivative;
        margin = WINDOW_RADIUS + derivative.reach;
        counts = new EventCounts(sensor, MAX_AGE_US);
    }

    @Override
    public void process(EventBatch batch, FlowOutput output) {
        int size = batch.size();
        Labels.checkCapacity(size, output);
        for (int i = 0; i < size; i++) {
            int x = batch.x[i];
            int y = batch.y[i];
            int polarity = batch.polarity[i];
            Labels.set(output, i, 0, 0);
            if (!sensor.contains(x, y)) {
                continue;
            }
            counts.add(batch.timeUs[i], x, y, polarity);
            if (x >= margin && y >= margin && x < sensor.width() - margin && y < sensor.height() - margin) {
                estimate(counts.cell(x, y, polarity));
                Labels.set(output, i, vx, vy);
            }
        }
    }

    @Override
    public void reset() {
        counts.reset();
    }

    private void estimate(int centre) {
        vx = 0;
        vy = 0;
        switch (derivative) {
            case BACKWARD_DIFFERENCE -> leastSquares(centre, 0);
            case CENTRAL_DIFFERENCE -> leastSquares(centre, 1);
            case SAVITZKY_GOLAY -> slope(centre);
        }
    }

    /** Estimates with differences between the pixel that is {@code ahead}, 0 or 1, and the pixel that is 1 behind. */
    private void leastSquares(int centre, int ahead) {
        int width = sensor.width();
        int[] n = counts.counts();
        double perS = (1 + ahead) * 1e6 / MAX_AGE_US;
        // Sums of integers are exact in a long.
        long xx = 0;
        long xy = 0;
        long yy = 0;
        long xn = 0;
        long yn = 0;
        for (int dy = -WINDOW_RADIUS; dy <= WINDOW_RADIUS; dy++) {
            int cell = centre + dy * width - WINDOW_RADIUS;
            for (int dx = -WINDOW_RADIUS; dx <= WINDOW_RADIUS; dx++, cell++) {
                int nx = n[cell + ahead] - n[cell - 1];
                int ny = n[cell + ahead * width] - n[cell - width];
                xx += nx * nx;
                xy += nx * ny;
                yy += ny * ny;
                xn += nx * n[cell];
                yn += ny * n[cell];
            }
        }
        double trace = xx + yy;
        double determinant = (double) xx * yy - (double) xy * xy;
        double root = Math.sqrt(Math.max(0, trace * trace - 4 * determinant));
        if ((trace + root) / 2 < MIN_EIGENVALUE) {
            return;
        }
        if ((trace - root) / 2 < MIN_EIGENVALUE) {
            normalFlow(n[centre + ahead] - n[centre - 1], n[centre + ahead * width] - n[centre - width],
                    n[centre] * perS);
            return;
        }
        vx = (xy * (double) yn - yy * (double) xn) / determinant * perS;
        vy = (xy * (double) xn - xx * (double) yn) / determinant * perS;
    }

    /**
     * Estimates with one slope for the whole window. The larger eigenvalue is the number of pixels times the squared
     * slope, and the other one is 0.
     */
    private void slope(int centre) {
        int width = sensor.width();
        int[] n = counts.counts();
        long x = 0;
        long y = 0;
        for (int dy = -WINDOW_RADIUS; dy <= WINDOW_RADIUS; dy++) {
            int cell = centre + dy * width - WINDOW_RADIUS;
            for (int dx = -WINDOW_RADIUS; dx <= WINDOW_RADIUS; dx++, cell++) {
                x += dx * n[cell];
                y += dy * n[cell];
            }
        }
        // Least squares on a centred grid: the sum of dx n over the sum of dx², which is 196 for 7 x 7.
        double squares = WINDOW * WINDOW_RADIUS * (WINDOW_RADIUS + 1) / 3.0;
        double nx = x / squares;
        double ny = y / squares;
        if (WINDOW * (nx * nx + ny * ny) >= MIN_EIGENVALUE) {
            normalFlow(nx, ny, n[centre] * 1e6 / MAX_AGE_US / WINDOW_RADIUS);
        }
    }

    private void normalFlow(double nx, double ny, double perS) {
        double square = nx * nx + ny * ny;
        if (square > 0) {
            vx = -nx * perS / square;
            vy = -ny * perS / square;
        }
    }
}
