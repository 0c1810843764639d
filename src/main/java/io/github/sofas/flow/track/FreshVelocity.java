package io.github.sofas.flow.track;

import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.fit.VelocityTop;
import io.github.sofas.flow.motion.Motion;

/**
 * Searches all directions for the velocity of a structure, using only the newest events, those of a few px of travel.
 * This is for a structure whose events come faster than its motion explains ({@link EventDensity#isRushed}), or that
 * sets off from rest.
 *
 * <p>Ours, because a measurement only goes from a motion to a better one beside it. A structure that turns back within
 * a few ms, as a head or a handheld camera does, is at rest for its window. Rest is a top of the metric of its own,
 * because real pixels fire several times as an edge passes. Such a structure therefore stayed at rest while it labelled
 * all of the events. The flow plane does not get these events, since the contour of the resting structure explains
 * them.
 */
final class FreshVelocity {
    /** Travel, in px, whose usual number of events is searched. */
    static final double TRAVEL_PX = 4;
    /** Speeds to try, as shares of the one that the event count indicates: the count is not exactly the usual one. */
    private static final double[] SPEEDS = {0.6, 1, 1.5};
    /** Distance between neighbouring velocities of one speed, in px over the time of the events. */
    private static final double SPACING_PX = 1.5;
    private static final int LEAST_EVENTS = 50;
    private static final int MOST_FITS = 5;
    /** Least metric per event. */
    private static final double LEAST_DENSITY = 0.7;

    private final NewestEvents events = new NewestEvents();
    private final Motion rest = new Motion();
    private double vx;
    private double vy;

    /** Returns the x component of the velocity that was found, in px/s. */
    double vx() {
        return vx;
    }

    double vy() {
        return vy;
    }

    /**
     * Searches for the velocity.
     *
     * @param newest number of the newest live events to use
     * @param travelPx travel over which the structure usually gives this number of events
     * @param sigmas standard deviations by which the metric must exceed those along the motion and at rest
     * @param motion motion that the structure is assumed to have
     * @param radius of the structure in px
     * @return whether the events show a velocity, and one that differs from the motion's
     */
    boolean find(LiveEvents live, int newest, double travelPx, double sigmas, Motion motion, double radius,
                 MetricFit fit) {
        long fromUs = live.newestFromUs(newest);
        long windowUs = live.newestUs() - fromUs;
        if (windowUs <= 0) {
            return false;
        }
        events.load(live, newest, motion, radius, fit);
        if (fit.size() < LEAST_EVENTS) {
            return false;
        }
        double known = fit.metric();
        rest.set(fromUs + windowUs / 2, 0, 0);
        events.load(live, newest, rest, radius, fit);
        known = Math.max(known, fit.metric());
        double window = windowUs * 1e-6;
        if (lookAround(travelPx, window, fit) <= known) {
            return false;
        }
        double metric = climb(window, fit);
        // in a sample events meet less often, by the share that it has of all
        double perEvent = metric / fit.size() * newest / fit.size();
        return metric - known > sigmas * MetricFit.sd(metric) && perEvent > LEAST_DENSITY;
    }

    /** Sets the velocity to the best of several speeds in all directions; returns its metric. */
    private double lookAround(double travelPx, double window, MetricFit fit) {
        double best = 0;
        for (double part : SPEEDS) {
            double speed = part * travelPx / window;
            int directions = (int) Math.ceil(2 * Math.PI * part * travelPx / SPACING_PX);
            for (int i = 0; i < directions; i++) {
                double angle = 2 * Math.PI * i / directions;
                double x = speed * StrictMath.cos(angle);
                double y = speed * StrictMath.sin(angle);
                double metric = fit.metric(x, y);
                if (metric > best) {
                    best = metric;
                    vx = x;
                    vy = y;
                }
            }
        }
        return best;
    }

    /** Moves the velocity to the top of the metric; returns the metric there. */
    private double climb(double window, MetricFit fit) {
        double px = 2 / window;
        double metric = 0;
        fit.frame(2 * px);
        for (int i = 0; i < MOST_FITS; i++) {
            VelocityTop top = i == 0 ? fit.fit(vx, vy, MetricFit.FLAT_SIGMAS)
                : fit.fitCross(vx, vy, MetricFit.FLAT_SIGMAS);
            vx += top.stepX();
            vy += top.stepY();
            metric = top.metric();
            fit.frame(top, MetricFit.NEIGHBOUR_LOSS, px);
        }
        return metric;
    }
}
