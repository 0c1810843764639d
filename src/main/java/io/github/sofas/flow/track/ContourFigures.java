package io.github.sofas.flow.track;

import io.github.sofas.flow.motion.Motion;
import io.github.sofas.flow.motion.SteppedProjection;

/**
 * Figures of a contour, measured from some of its live events: its place, its size, and the mean support of its own
 * events. That mean determines how much support an event needs to lie on the contour.
 */
final class ContourFigures {
    /** Support by two sixteenths: less never puts an event on the contour. */
    private static final int LEAST_SUPPORT = 4;
    /** Share of the mean support that puts an event on the contour. A contour a pixel wide loses events to jitter. */
    private static final double SHARE = 0.25;
    /** Share of the mean close support below which it is doubtful whether an event belongs to the structure. */
    private static final double SURE_SHARE = 0.6;
    /** Number of live events that are measured, about. */
    private static final int SAMPLE = 256;

    private final SteppedProjection past = new SteppedProjection();
    private int threshold;
    private double sureSupport;
    private double centreX;
    private double centreY;
    private double radius;
    private double breadth;

    /** Starts with nothing known: all events are doubtful. */
    void start() {
        threshold = LEAST_SUPPORT;
        sureSupport = Double.MAX_VALUE;
        centreX = 0;
        centreY = 0;
        radius = 0;
        breadth = 0;
    }

    /** Least support that puts an event on the contour. */
    int threshold() {
        return threshold;
    }

    /** Close support below which it is doubtful whether an event belongs to the structure. */
    double sureSupport() {
        return sureSupport;
    }

    /** Centre of the contour, x in px of the sensor. */
    double centreX() {
        return centreX;
    }

    double centreY() {
        return centreY;
    }

    /** Root mean square distance of the contour from its centre, in px. */
    double radius() {
        return radius;
    }

    /** Standard deviation of the contour along its narrowest axis, in px; a square has 0.29 of its side. */
    double breadth() {
        return breadth;
    }

    /**
     * Measures the live events that lie in the box of the contour. If there are none, only the size changes, to 0.
     *
     * @param along the motion that the contour follows, with the current time as its reference
     * @param isEither whether events of either polarity are expected where one polarity was seen
     * @param noiseSupport support that noise may have
     */
    void measure(ContourCells cells, Frame frame, LiveEvents live, Motion along, boolean isEither, int noiseSupport) {
        int n = 0;
        long support = 0;
        long closeSupport = 0;
        double sumX = 0;
        double sumY = 0;
        double squares = 0;
        double sumXx = 0;
        double sumXy = 0;
        int stride = Math.max(1, live.size() / SAMPLE);
        if (live.size() > 0) {
            past.begin(along, along.referenceUs - live.oldestUs(), 2 * radius, Contour.PROJECTED_STEP_PX);
        }
        for (int k = 0; k < live.size(); k += stride) {
            int i = live.index(k);
            past.advance(live.timeUs[i]);
            double x = past.x(live.x[i], live.y[i]);
            double y = past.y(live.x[i], live.y[i]);
            double inFrameX = frame.fromReferenceX(x, y);
            double inFrameY = frame.fromReferenceY(x, y);
            int cx = ContourCells.cell(inFrameX);
            int cy = ContourCells.cell(inFrameY);
            if (!cells.isInBox(cx, cy)) {
                continue;
            }
            int polarity = isEither ? ContourCells.EITHER : live.sign[i];
            support += cells.support(cx, cy, polarity);
            closeSupport += cells.closeSupport(ContourCells.firstOfTwo(inFrameX), ContourCells.firstOfTwo(inFrameY),
                polarity);
            sumX += x;
            sumY += y;
            squares += x * x + y * y;
            sumXx += x * x;
            sumXy += x * y;
            n++;
        }
        if (n == 0) {
            radius = 0;
            breadth = 0;
            return;
        }
        threshold = Math.max(Math.max(LEAST_SUPPORT, noiseSupport), (int) (SHARE * support / n));
        sureSupport = SURE_SHARE * closeSupport / n;
        centreX = sumX / n;
        centreY = sumY / n;
        radius = Math.sqrt(Math.max(0, squares / n - centreX * centreX - centreY * centreY));
        double xx = sumXx / n - centreX * centreX;
        double xy = sumXy / n - centreX * centreY;
        // the smaller eigenvalue of the covariance, whose trace is the square of the radius
        double difference = 2 * xx - radius * radius;
        breadth = Math.sqrt(Math.max(0, 0.5 * (radius * radius - Math.sqrt(difference * difference + 4 * xy * xy))));
    }
}
