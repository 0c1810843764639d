package io.github.sofas.flow.track;

import io.github.sofas.flow.motion.Motion;
import io.github.sofas.flow.motion.SteppedProjection;

/**
 * What is measured of a contour from some of its live events: where it lies, how large it is, and how much support its
 * own events have, which tells what support an event needs.
 */
final class ContourFigures {
    /** Support of two sixteenths: less never puts an event on the contour. */
    private static final int LEAST_SUPPORT = 4;
    /** Share of the mean support that puts an event on the contour: one a pixel wide loses events to jitter. */
    private static final double SHARE = 0.25;
    /** Share of the mean close support below which it is doubtful whether an event is of the structure. */
    private static final double SURE_SHARE = 0.6;
    /** Live events that are looked at. */
    private static final int SAMPLE = 256;

    private final SteppedProjection past = new SteppedProjection();
    private int threshold;
    private double sureSupport;
    private double centreX;
    private double centreY;
    private double radius;
    private double breadth;

    /** Begins with nothing known. */
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

    /** Close support below which it is doubtful whether an event is of the structure. */
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

    /** Distance of the contour from its centre, root of the mean square, in px. */
    double radius() {
        return radius;
    }

    /** Its standard deviation along the axis in which it is narrowest, in px: that of a square by 0.29 of its side. */
    double breadth() {
        return breadth;
    }

    /**
     * Measures the live events that lie in the box of the contour; of none, nothing but the size is another.
     *
     * @param along the motion that the contour follows, with its reference at now
     * @param isEither whether events of either polarity are expected where those of one were seen
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
