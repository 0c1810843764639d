package io.github.sofas.flow.track;

import io.github.sofas.flow.motion.Motion;

/**
 * Follows a structure by its place while it slows down, stands, or turns round: its contour, as it was, is laid on its
 * newest events again and again, whatever their polarity. Ours, because a velocity is seen after some pixels of travel
 * in one direction, and until then the contour was where the structure had been going: what turned round was lost for
 * 0.15 s.
 *
 * <p>Place and velocity are those of a Kalman filter whose acceleration is white noise. How strong that is follows from
 * the speed before: about as much as stops the structure within a few lifetimes.
 */
final class PlaceTrack {
    private static final int MOST_POINTS = 1 << 12;
    private static final int MOST_PLACES = 1 << 8;
    /** New events that it is laid on, and the time after which it is with fewer. */
    private static final int EVENTS = 12;
    private static final long LONGEST_US = 20_000;
    /** How far beside the box events are counted, in px. */
    private static final int BESIDE_PX = 3;
    /** Variance of a place that one event shows, in px². */
    private static final double EVENT_VARIANCE = 2;
    /** Variance of the place at the beginning, in px². */
    private static final double FIRST_VARIANCE = 1;
    /** Spectral density of the acceleration, as a share of the cube of the speed by the lifetime. */
    private static final double UNREST = 0.25;
    /** Share of the events expected below which it is taken to be slower. */
    private static final double FEW = 0.5;
    /** Travel at its speed over which it then loses that speed, in px. */
    private static final double STOP_PX = 2;
    /** Travel that shows the velocity. */
    static final double SHOWN_PX = 4;

    // the contour, from its centre, as it lay at the beginning
    private final float[] pointX = new float[MOST_POINTS];
    private final float[] pointY = new float[MOST_POINTS];
    private int points;
    private double angle;
    // places that it was at
    private final long[] placeUs = new long[MOST_PLACES];
    private final double[] placeX = new double[MOST_PLACES];
    private final double[] placeY = new double[MOST_PLACES];
    private final double[] placeAngle = new double[MOST_PLACES];
    private int places;
    private int shown;
    private long followedUs;
    // variances of place and velocity, the same in all directions, and that of turns at the radius
    private double placeVariance;
    private double covariance;
    private double velocityVariance;
    private double unrest;

    private double radius;

    /** Bytes that its arrays take. */
    static long bytes() {
        return 2L * MOST_POINTS * Float.BYTES + (Long.BYTES + 3L * Double.BYTES) * MOST_PLACES;
    }

    /**
     * Begins with a contour, which the motion's centre is that of.
     *
     * @param turned since the contour was projected, in rad
     * @param speed before it slowed down, in px/s
     * @param sinceUs time from which on the contour has not been laid on events
     * @return false where the contour has too many points
     */
    boolean start(Contour contour, double turned, double speed, double lifetimePx, long sinceUs) {
        points = contour.list(pointX, pointY);
        if (points > MOST_POINTS) {
            return false;
        }
        radius = Math.max(2, contour.radius());
        angle = turned;
        places = 0;
        followedUs = sinceUs;
        placeVariance = FIRST_VARIANCE;
        covariance = 0;
        velocityVariance = speed * speed / 4;
        unrest = UNREST * speed * speed * speed / lifetimePx;
        return true;
    }

    /** Whether enough new events came, or time passed, to lay the contour on them. */
    boolean isDue(Contour contour, LiveEvents live, StrayEvents strays, long nowUs) {
        if (nowUs - followedUs >= LONGEST_US) {
            return true;
        }
        double dt = (nowUs - contour.motion().referenceUs) * 1e-6;
        double x = contour.motion().vx * dt;
        double y = contour.motion().vy * dt;
        int n = live.since(followedUs);
        for (int k = 0; k < strays.size() && n < EVENTS; k++) {
            int i = strays.index(k);
            if (strays.timeUs[i] <= followedUs) {
                break;
            }
            double px = strays.x[i] - x;
            double py = strays.y[i] - y;
            if (px >= contour.left() - BESIDE_PX && px <= contour.right() + BESIDE_PX
                    && py >= contour.top() - BESIDE_PX && py <= contour.bottom() + BESIDE_PX) {
                n++;
            }
        }
        return n >= EVENTS;
    }

    /**
     * Lays the contour on the events since the last time.
     *
     * @param motion is moved to now, and becomes that of the place found
     * @param eventsPerPx that the structure has had for each px of its travel
     */
    void follow(Motion motion, LiveEvents live, StrayEvents strays, Registration registration, double eventsPerPx,
                long nowUs) {
        double since = (nowUs - motion.referenceUs) * 1e-6;
        motion.moveReference(nowUs);
        angle += motion.omega * since;
        placeVariance += since * (2 * covariance + since * (velocityVariance + unrest * since / 3));
        covariance += since * (velocityVariance + unrest * since / 2);
        velocityVariance += unrest * since;
        load(registration, motion, live, strays);
        boolean agrees = registration.fit(radius);
        if (agrees) {
            correct(registration, motion);
        }
        double travelPx = motion.speed(radius) * (nowUs - followedUs) * 1e-6;
        double few = FEW * eventsPerPx * travelPx;
        if (registration.agreement() < few) {
            motion.slowDown(1 - Math.min(1, travelPx / STOP_PX) * (1 - registration.agreement() / few));
        }
        followedUs = nowUs;
        int place = places++ & MOST_PLACES - 1;
        placeUs[place] = nowUs;
        placeX[place] = motion.centreX;
        placeY[place] = motion.centreY;
        placeAngle[place] = angle;
    }

    /** The contour at its place, and the events since the last time, carried on to now. */
    private void load(Registration registration, Motion motion, LiveEvents live, StrayEvents strays) {
        registration.start(motion.centreX, motion.centreY);
        double cos = StrictMath.cos(angle);
        double sin = StrictMath.sin(angle);
        for (int i = 0; i < points; i++) {
            registration.addContour(motion.centreX + cos * pointX[i] - sin * pointY[i],
                motion.centreY + sin * pointX[i] + cos * pointY[i]);
        }
        for (int k = live.size() - live.since(followedUs); k < live.size(); k++) {
            int i = live.index(k);
            motion.project(live.x[i], live.y[i], live.timeUs[i]);
            registration.addEvent(motion.x, motion.y);
        }
        for (int k = 0; k < strays.size(); k++) {
            int i = strays.index(k);
            if (strays.timeUs[i] <= followedUs) {
                break;
            }
            motion.project(strays.x[i], strays.y[i], strays.timeUs[i]);
            registration.addEvent(motion.x, motion.y);
        }
    }

    /** The Kalman filter's update. */
    private void correct(Registration registration, Motion motion) {
        double variance = placeVariance + EVENT_VARIANCE / registration.agreement();
        double placeGain = placeVariance / variance;
        double velocityGain = covariance / variance;
        velocityVariance -= velocityGain * covariance;
        covariance *= 1 - placeGain;
        placeVariance *= 1 - placeGain;
        motion.centreX += placeGain * registration.shiftX();
        motion.centreY += placeGain * registration.shiftY();
        angle += placeGain * registration.turn();
        motion.vx += velocityGain * registration.shiftX();
        motion.vy += velocityGain * registration.shiftY();
        motion.omega += velocityGain * registration.turn();
    }

    /** Draws the contour at its place. */
    void draw(Contour contour, Motion motion) {
        contour.draw(pointX, pointY, points, motion, angle, radius);
    }

    /** How far it has turned since the beginning, in rad. */
    double angle() {
        return angle;
    }

    /** When it was last so far from where it is that its velocity shows, in µs; or {@link Long#MAX_VALUE}. */
    long movesSince(Motion motion) {
        for (int k = 2; k <= Math.min(places, MOST_PLACES); k++) {
            int place = places - k & MOST_PLACES - 1;
            double dx = motion.centreX - placeX[place];
            double dy = motion.centreY - placeY[place];
            double turned = (angle - placeAngle[place]) * radius;
            if (dx * dx + dy * dy + turned * turned >= SHOWN_PX * SHOWN_PX) {
                shown = place;
                return placeUs[place];
            }
        }
        return Long.MAX_VALUE;
    }

    /** Gives a motion, by half, the mean velocity since the time that was found last. */
    void takeVelocity(Motion motion) {
        double since = (motion.referenceUs - placeUs[shown]) * 1e-6;
        motion.vx = (motion.vx + (motion.centreX - placeX[shown]) / since) / 2;
        motion.vy = (motion.vy + (motion.centreY - placeY[shown]) / since) / 2;
        motion.omega = (motion.omega + (angle - placeAngle[shown]) / since) / 2;
    }
}
