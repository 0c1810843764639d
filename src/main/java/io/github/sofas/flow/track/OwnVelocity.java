package io.github.sofas.flow.track;

import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.fit.VelocityTop;

/**
 * The velocity that some events of a structure show by themselves, in addition to the motion that they are projected
 * along.
 */
final class OwnVelocity {
    /** Fits after the first step. */
    private static final int FITS = 2;

    private double vx;
    private double vy;

    /** Velocity to the right, in px/s. */
    double vx() {
        return vx;
    }

    /** The same, downwards. */
    double vy() {
        return vy;
    }

    /** Shift of the ends of the window by this velocity, in px. */
    double shiftPx(double half) {
        return Math.hypot(vx, vy) * half;
    }

    /**
     * Takes a first step from the motion that the events were projected along, by the slopes of the metric.
     *
     * @param fit holds the events
     * @param half half the window in s
     * @return the metric before the step
     */
    double begin(MetricFit fit, double half) {
        double px = px(half);
        vx = 0;
        vy = 0;
        fit.frame(px);
        return step(fit.fitSlopes(px, MetricFit.FLAT_SIGMAS), fit, px);
    }

    /** Continues to the top of the metric; returns the metric near the top. */
    double goOn(MetricFit fit, double half) {
        double metric = 0;
        for (int i = 0; i < FITS; i++) {
            metric = step(fit.fit(vx, vy, MetricFit.FLAT_SIGMAS), fit, px(half));
        }
        return metric;
    }

    /** Velocity that shifts both ends of the window by one pixel. */
    private static double px(double half) {
        return 1 / half;
    }

    private double step(VelocityTop top, MetricFit fit, double px) {
        vx += top.stepX();
        vy += top.stepY();
        fit.frame(top, MetricFit.neighbourLoss(top.metric()), px);
        return top.metric();
    }
}
