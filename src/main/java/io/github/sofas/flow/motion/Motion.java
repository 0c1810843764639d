package io.github.sofas.flow.motion;

/**
 * How a structure moves on the sensor: velocity, acceleration, and rotation about a centre that moves along. Ours
 * beyond the paper's velocity: section Conclusion names acceleration and rotation as where it fails.
 *
 * <p>Seen from a reference time t0, with dt = t - t0, an event at u of time t was or will be at
 * R(-omega dt) (u - c - v dt - a dt²/2) + c.
 */
public final class Motion {
    /** t0 in µs. */
    public long referenceUs;
    /** Velocity of the centre at t0 in px/s. */
    public double vx;
    public double vy;
    /** Acceleration of the centre in px/s². */
    public double ax;
    public double ay;
    /** Rotation in rad/s; positive turns x towards y, clockwise as seen. */
    public double omega;
    /** Centre of rotation at t0 in px. */
    public double centreX;
    public double centreY;

    /** Where the event projected last falls, in px. */
    public double x;
    public double y;

    /** Becomes a steady motion of a velocity in px/s; the centre stays. */
    public void set(long timeUs, double newVx, double newVy) {
        referenceUs = timeUs;
        vx = newVx;
        vy = newVy;
        ax = 0;
        ay = 0;
        omega = 0;
    }

    /** Becomes the same as another. */
    public void copyFrom(Motion other) {
        referenceUs = other.referenceUs;
        vx = other.vx;
        vy = other.vy;
        ax = other.ax;
        ay = other.ay;
        omega = other.omega;
        centreX = other.centreX;
        centreY = other.centreY;
    }

    /** Moves the reference in time; the motion stays the same. */
    public void moveReference(long timeUs) {
        double dt = (timeUs - referenceUs) * 1e-6;
        centreX += (vx + 0.5 * ax * dt) * dt;
        centreY += (vy + 0.5 * ay * dt) * dt;
        vx += ax * dt;
        vy += ay * dt;
        referenceUs = timeUs;
    }

    /** Moves the centre of rotation; the motion of every point stays the same, but for its acceleration. */
    public void moveCentre(double newX, double newY) {
        vx -= omega * (newY - centreY);
        vy += omega * (newX - centreX);
        centreX = newX;
        centreY = newY;
    }

    /** Scales all velocities down. */
    public void slowDown(double factor) {
        vx *= factor;
        vy *= factor;
        omega *= factor;
    }

    /** Projects an event to the reference time, into {@link #x} and {@link #y}. */
    public void project(int eventX, int eventY, long timeUs) {
        double dt = (timeUs - referenceUs) * 1e-6;
        double px = eventX - (vx + 0.5 * ax * dt) * dt;
        double py = eventY - (vy + 0.5 * ay * dt) * dt;
        if (omega != 0) {
            double turn = omega * dt;
            double rx = px - centreX;
            double ry = py - centreY;
            // sine and 1 - cosine to a few parts in 10,000 of half a turn in a window
            double square = turn * turn;
            double sine = turn * (1 - square / 6);
            double versine = 0.5 * square * (1 - square / 12);
            px += sine * ry - versine * rx;
            py -= sine * rx + versine * ry;
        }
        x = px;
        y = py;
    }

    /** Velocity in px/s at a point of the sensor and a time. */
    public float vxAt(int eventY, long timeUs) {
        double dt = (timeUs - referenceUs) * 1e-6;
        return (float) (vx + ax * dt - omega * (eventY - centreY - vy * dt));
    }

    /** The same, downwards. */
    public float vyAt(int eventX, long timeUs) {
        double dt = (timeUs - referenceUs) * 1e-6;
        return (float) (vy + ay * dt + omega * (eventX - centreX - vx * dt));
    }

    /** Speed in px/s, root of the mean square over points whose distance from the centre has that of radius. */
    public double speed(double radius) {
        return Math.sqrt(vx * vx + vy * vy + omega * omega * radius * radius);
    }
}
