package io.github.sofas.flow.track;

import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.fit.VelocityTop;
import io.github.sofas.flow.motion.Motion;
import io.github.sofas.flow.motion.SteppedProjection;

/**
 * Looks for the velocity of a structure whose events come faster than its motion takes it on
 * ({@link EventDensity#isRushed}), or that sets off from rest: in all directions, from the newest events alone, those
 * of a few px of travel.
 *
 * <p>Ours, because measuring goes from a motion to a better one beside it. What turns back in a few ms, as a head does
 * or a camera held by hand, is at rest for its window, and rest is a top of the metric of its own: real pixels fire
 * several times as an edge passes. So it stayed at rest while it labelled all of the events. The flow plane does not
 * get these events, since the contour of what rests explains them.
 */
final class FreshVelocity {
    /** Travel whose usual events are looked at, in px. */
    static final double TRAVEL_PX = 4;
    /** Speeds that are tried, as shares of the one that the number of events tells, which is not exactly as usual. */
    private static final double[] SPEEDS = {0.6, 1, 1.5};
    /** Distance between the velocities of one speed that are tried, over the time of the events, in px. */
    private static final double SPACING_PX = 1.5;
    /** Most events that are looked at; of more, those on a part of the tiles. */
    private static final int MOST_EVENTS = 3000;
    private static final int LEAST_EVENTS = 50;
    /** Events are projected along the motion in steps of this part of a pixel. */
    private static final double STEP_PX = 1.0 / 32;
    private static final int MOST_FITS = 5;
    /** Metric per event, at least. */
    private static final double LEAST_DENSITY = 0.7;

    private final SteppedProjection stepped = new SteppedProjection();
    private final Motion rest = new Motion();
    private double vx;
    private double vy;

    /** Velocity that was found, in px/s. */
    double vx() {
        return vx;
    }

    double vy() {
        return vy;
    }

    /**
     * Looks for it.
     *
     * @param newest how many of the live events are looked at
     * @param travelPx over which the structure usually gives as many
     * @param sigmas standard deviations by which the metric must pass that along the motion, and that at rest
     * @param motion that it is taken to have
     * @param radius of the structure in px
     * @return whether the events show a velocity, and another one than the motion's
     */
    boolean find(LiveEvents live, int newest, double travelPx, double sigmas, Motion motion, double radius,
                 MetricFit fit) {
        long fromUs = live.newestFromUs(newest);
        long windowUs = live.newestUs() - fromUs;
        if (windowUs <= 0) {
            return false;
        }
        load(live, newest, motion, radius, fit);
        if (fit.size() < LEAST_EVENTS) {
            return false;
        }
        double known = fit.metric();
        rest.set(fromUs + windowUs / 2, 0, 0);
        load(live, newest, rest, radius, fit);
        known = Math.max(known, fit.metric());
        double window = windowUs * 1e-6;
        if (lookAround(travelPx, window, fit) <= known) {
            return false;
        }
        double metric = climb(window, fit);
        // in a sample events meet by so much less
        double perEvent = metric / fit.size() * newest / fit.size();
        return metric - known > sigmas * MetricFit.sd(metric) && perEvent > LEAST_DENSITY;
    }

    private void load(LiveEvents live, int newest, Motion along, double radius, MetricFit fit) {
        int halvings = 0;
        while (newest >> halvings > MOST_EVENTS) {
            halvings++;
        }
        fit.clear();
        long fromUs = live.newestFromUs(newest);
        stepped.begin(along, Math.abs(along.referenceUs - fromUs), 2 * radius, STEP_PX);
        for (int k = live.size() - newest; k < live.size() && fit.size() < fit.capacity(); k++) {
            int i = live.index(k);
            if (live.isLeftBy(halvings, i) && live.claim(i) == Claim.OWN) {
                stepped.advance(live.timeUs[i]);
                fit.add((float) stepped.x(live.x[i], live.y[i]), (float) stepped.y(live.x[i], live.y[i]),
                    (live.timeUs[i] - along.referenceUs) * 1e-6f, 0, 0, live.sign[i]);
            }
        }
    }

    /** Goes to the best velocity of several speeds in all directions; returns its metric. */
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

    /** Goes to the top of the metric; returns it. */
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
