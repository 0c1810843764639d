package io.github.sofas.baseline;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.EventLabeller;
import io.github.sofas.flow.FlowOutput;

/**
 * Lucas-Kanade for events (Benosman et al., "Asynchronous frameless event-based optical flow", Neural Networks 27,
 * 2012) as implemented and improved by Rueckauer and Delbruck 2016.
 *
 * <p>With n(x, y) the number of the event's polarity's events at a pixel in the last {@link #MAX_AGE_US}, brightness is
 * taken to be n and its change in time n / T, T that age: over the window W of 7 x 7 pixels around the event
 * <pre>
 *   minimise over v   sum over W of (nx vx + ny vy + n / T)²
 * </pre>
 * where nx and ny are differences of n ({@link Derivative}). With the eigenvalues l1 &gt;= l2 of the sum of products
 * of (nx, ny), there is no flow where l1 &lt; 1, normal flow at the centre pixel, v = -(nx, ny) n / (T |(nx, ny)|²),
 * where l2 &lt; 1, and the least-squares solution otherwise.
 *
 * <p>Counts are no brightness: they rise while an edge comes and fall only by age, so that the flow is too slow, by
 * 80 % with central differences and by 20 to 40 % with {@link Derivative#SAVITZKY_GOLAY}.
 *
 * <p>Differs from jAER's LucasKanadeFlow: events near the border are counted, though not labelled; T is the true age
 * where jAER writes 1 / T = 20 / s for every age, the same at its default; its speed control, which drops speeds above
 * twice their running mean, is left out, as is its shift of time over gaps. With {@link Derivative#SAVITZKY_GOLAY} the
 * change in time is divided by the window's radius, as there: a calibration without a derivation.
 */
public final class LucasKanade implements EventLabeller {
    /** Pixels from the middle of the window to its side: 7 x 7. jAER's default. */
    public static final int WINDOW_RADIUS = 3;
    /** Events older than this are not counted, in µs. jAER's default. */
    public static final long MAX_AGE_US = 50_000;
    /** Smallest eigenvalue that is a gradient, in squared differences summed over the window. jAER's default. */
    public static final double MIN_EIGENVALUE = 1;

    private static final int WINDOW = (2 * WINDOW_RADIUS + 1) * (2 * WINDOW_RADIUS + 1);

    /** How counts are differentiated. Sums in the eigenvalues' bound are of the differences as they stand here. */
    public enum Derivative {
        /** n(x) - n(x - 1): the original, pulled to the left and up. */
        BACKWARD_DIFFERENCE(1),
        /** n(x + 1) - n(x - 1), against twice the change in time. jAER's default. */
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
     * Makes one with {@link Derivative#SAVITZKY_GOLAY}, the best of the three: it has the -35 % of magnitude error that
     * the SOFAS paper found Lucas-Kanade to have.
     *
     * @param sensor size of the sensor
     */
    public LucasKanade(SensorSize sensor) {
        this(sensor, Derivative.SAVITZKY_GOLAY);
    }

    /**
     * Makes one.
     *
     * @param sensor size of the sensor
     * @param derivative how brightness is differentiated
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

    /** Differences between the pixel so far ahead, 0 or 1, and the one behind. */
    private void leastSquares(int centre, int ahead) {
        int width = sensor.width();
        int[] n = counts.counts();
        double perS = (1 + ahead) * 1e6 / MAX_AGE_US;
        // Sums of integers, exact in a long.
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

    /** One slope for the whole window: its larger eigenvalue is the window's pixels times its square, the other 0. */
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
        // Least squares on a centred grid: sum of dx n over sum of dx², 196 for 7 x 7.
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
