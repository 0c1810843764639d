package io.github.sofas.flow.fit;

import io.github.sofas.flow.motion.Motion;

/**
 * How the path of a structure bends. Ours, because what follows a bend turns with it, be it a pendulum, a car or a
 * fish, and a body as round as a pendulum's bob shows nothing of its rotation by itself: taken as none, the flow on a
 * bob of 15 px that swings 300 px below its pivot is wrong by a twentieth at its rim.
 *
 * <p>The bend is one over the radius of the path's circle, positive where the path turns from x towards y. Its centre
 * stays where it is when the structure turns round and comes back on its path, so that the sign changes then.
 */
final class PathBend {
    /** Turn of the path over its remembered length that may be noise, in rad: 1.5 degrees. */
    private static final double NOISE_RAD = 0.026;
    /** Cosine of the angle between two measurements above which the path has not turned but broken off. */
    private static final double BROKEN = 0.7;

    /** Least travel between two headings: what nearly stands has none. */
    private static final double STEP_PX = 2;

    private double bend;
    private double headingX;
    private double headingY;
    private long timeUs;

    /** Begins with a straight path. */
    void start(long nowUs) {
        bend = 0;
        headingX = 0;
        headingY = 0;
        timeUs = nowUs;
    }

    /**
     * Follows the path on.
     *
     * @param lengthPx path over which its bend is averaged
     */
    void follow(Motion motion, double lengthPx) {
        double speed = StrictMath.hypot(motion.vx, motion.vy);
        double travelPx = speed * (motion.referenceUs - timeUs) * 1e-6;
        if (travelPx < STEP_PX) {
            return;
        }
        double ux = motion.vx / speed;
        double uy = motion.vy / speed;
        double onward = ux * headingX + uy * headingY;
        if (onward > BROKEN) {
            double turned = headingX * uy - headingY * ux;
            bend += (turned - travelPx * bend) / Math.max(lengthPx, 2 * travelPx);
        } else {
            bend *= onward;
        }
        headingX = ux;
        headingY = uy;
        timeUs = motion.referenceUs;
    }

    /** Rotation in rad/s of a body that turns with the path; none where the bend may be noise. */
    double omega(Motion motion, double lengthPx) {
        double turn = bend * lengthPx;
        double square = turn * turn;
        return bend * StrictMath.hypot(motion.vx, motion.vy) * square / (square + NOISE_RAD * NOISE_RAD);
    }
}
