package io.github.sofas.flow.search;

import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.fit.VelocityTop;

/**
 * Climbs from a velocity to the top of the metric of the events that a fit holds, a fit with each step (paper, section
 * Structure Detection, refining cycles). The first fit has projections all around the velocity, the others along the
 * axes of what is known.
 */
final class VelocityClimb {
    private static final int FEWEST_FITS = 3;
    private static final int MOST_FITS = 8;
    /** Length of a step to the top, in distances of projections, below which the climb has arrived. */
    private static final double ARRIVED_STEPS = 0.3;
    /**
     * A velocity is known along both axes where a shift of both ends of the window by one pixel loses at least so many
     * standard deviations of the metric, in any direction.
     */
    private static final double KNOWN_SIGMAS = 1;

    private final MetricFit fit;
    /** Velocity that shifts both ends of the window by one pixel. */
    private double px;
    private double vx;
    private double vy;
    private int fits;
    private VelocityTop top;

    VelocityClimb(MetricFit fit) {
        this.fit = fit;
    }

    /**
     * Begins at a velocity in px/s.
     *
     * @param windowS time from the first to the last event, in s
     * @param distancePx distance of the first projections, in px at the ends of the window
     */
    void begin(double fromVx, double fromVy, double windowS, double distancePx) {
        px = 2 / windowS;
        vx = fromVx;
        vy = fromVy;
        fits = 0;
        fit.frame(distancePx * px);
    }

    /** Makes the next fit, and goes to its top, which is valid until the next fit. */
    VelocityTop step() {
        if (fits > 0) {
            fit.frame(top, MetricFit.NEIGHBOUR_LOSS, px);
        }
        top = fits == 0 ? fit.fit(vx, vy, MetricFit.FLAT_SIGMAS) : fit.fitCross(vx, vy, MetricFit.FLAT_SIGMAS);
        vx += top.stepX();
        vy += top.stepY();
        fits++;
        return top;
    }

    /** Whether the last step led to the top, or there have been as many as there may be. */
    boolean hasArrived() {
        return fits == MOST_FITS || fits >= FEWEST_FITS && top.steps() < ARRIVED_STEPS;
    }

    /** Whether the last fit shows the velocity along both axes. */
    boolean isKnown() {
        return top.leastLoss() * px * px > KNOWN_SIGMAS * MetricFit.sd(top.metric());
    }

    /** Number of fits so far. */
    int fits() {
        return fits;
    }

    /** The velocity in px/s. */
    double vx() {
        return vx;
    }

    double vy() {
        return vy;
    }
}
