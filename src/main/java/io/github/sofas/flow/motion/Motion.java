package io.github.sofas.flow.motion;

/**
 * How a structure moves on the sensor: velocity, acceleration, rotation, growth and deformation about a centre that
 * moves along. Ours beyond the paper's velocity: section Conclusion names acceleration and rotation as where it fails.
 *
 * <p>A point at r from the centre has the velocity v + omega x r + growth r, and what the {@link Deformation} adds. But
 * for that, seen from a reference time t0, with dt = t - t0, an event at u of time t was or will be at
 * exp(-growth dt - growthChange dt²/2) R(-omega dt - alpha dt²/2) (u - c - v dt - a dt²/2) + c
 * ({@link SteppedProjection}).
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
    /**
     * What the acceleration changes by as the reference moves, in px/s³; what is projected, about the reference, has
     * that of the reference.
     */
    public double jerkX;
    public double jerkY;
    /** Rotation at t0 in rad/s; positive turns x towards y, clockwise as seen. */
    public double omega;
    /** Change of the rotation in rad/s². */
    public double alpha;
    /** What that changes by as the reference moves, in rad/s³, as the jerk. */
    public double alphaChange;
    /** Growth in 1/s, half the divergence of the flow; of what comes nearer 1/growth is the time to contact. */
    public double growth;
    /** Change of the growth in 1/s². */
    public double growthChange;
    /** How its flow departs from that, as the flow of what is seen at a slant; it does not change. */
    public final Deformation deformation = new Deformation();
    /** Centre of rotation, growth and deformation at t0 in px. */
    public double centreX;
    public double centreY;

    /** Begins with a steady velocity. */
    public void set(long timeUs, double newVx, double newVy) {
        referenceUs = timeUs;
        vx = newVx;
        vy = newVy;
        omega = 0;
        growth = 0;
        deformation.clear();
        hold();
    }

    /** Goes on as it is at the reference: neither velocity, nor rotation, nor growth changes. */
    public void hold() {
        ax = 0;
        ay = 0;
        jerkX = 0;
        jerkY = 0;
        alpha = 0;
        alphaChange = 0;
        growthChange = 0;
    }

    /** Becomes the same as another. */
    public void copyFrom(Motion other) {
        referenceUs = other.referenceUs;
        vx = other.vx;
        vy = other.vy;
        ax = other.ax;
        ay = other.ay;
        jerkX = other.jerkX;
        jerkY = other.jerkY;
        omega = other.omega;
        alpha = other.alpha;
        alphaChange = other.alphaChange;
        growth = other.growth;
        growthChange = other.growthChange;
        deformation.copyFrom(other.deformation);
        centreX = other.centreX;
        centreY = other.centreY;
    }

    /** Moves the reference in time; the motion stays the same. */
    public void moveReference(long timeUs) {
        double dt = (timeUs - referenceUs) * 1e-6;
        centreX += (vx + (0.5 * ax + jerkX * dt / 6) * dt) * dt;
        centreY += (vy + (0.5 * ay + jerkY * dt / 6) * dt) * dt;
        vx += (ax + 0.5 * jerkX * dt) * dt;
        vy += (ay + 0.5 * jerkY * dt) * dt;
        ax += jerkX * dt;
        ay += jerkY * dt;
        omega += (alpha + 0.5 * alphaChange * dt) * dt;
        alpha += alphaChange * dt;
        growth += growthChange * dt;
        referenceUs = timeUs;
    }

    /**
     * Moves the centre; the motion of every point stays the same, but for what it is drawn towards the centre by the
     * square of the rotation and of the growth: where the centre is a pixel off, that is noise.
     */
    public void moveCentre(double newX, double newY) {
        double rx = newX - centreX;
        double ry = newY - centreY;
        vx += growth * rx - omega * ry + deformation.vx(rx, ry);
        vy += growth * ry + omega * rx + deformation.vy(rx, ry);
        omega += deformation.omegaAt(rx, ry);
        growth += deformation.growthAt(rx, ry);
        deformation.moveCentre(rx, ry);
        ax += growthChange * rx - alpha * ry;
        ay += growthChange * ry + alpha * rx;
        centreX = newX;
        centreY = newY;
    }

    /** Moves the reference, and then the centre, to those of another motion. */
    public void follow(Motion other) {
        moveReference(other.referenceUs);
        moveCentre(other.centreX, other.centreY);
    }

    /** Velocity to the right of a point of the sensor at a time, in px/s. */
    public float vxAt(int x, int y, long timeUs) {
        double dt = (timeUs - referenceUs) * 1e-6;
        double rx = x - centreX - vx * dt;
        double ry = y - centreY - vy * dt;
        return (float) (vx + ax * dt - (omega + alpha * dt) * ry + (growth + growthChange * dt) * rx
            + deformation.vx(rx, ry));
    }

    /** The same, downwards. */
    public float vyAt(int x, int y, long timeUs) {
        double dt = (timeUs - referenceUs) * 1e-6;
        double rx = x - centreX - vx * dt;
        double ry = y - centreY - vy * dt;
        return (float) (vy + ay * dt + (omega + alpha * dt) * rx + (growth + growthChange * dt) * ry
            + deformation.vy(rx, ry));
    }

    /** Whether the velocity of a point changes by more than half of its speed while it travels so many px. */
    public boolean bendsWithin(double px, int x, int y, long timeUs) {
        double pointVx = vxAt(x, y, timeUs);
        double pointVy = vyAt(x, y, timeUs);
        return Math.hypot(ax, ay) * 2 * px > pointVx * pointVx + pointVy * pointVy;
    }

    /**
     * A speed in px/s that a point is no faster than from one time until another, in which it travels, turns and grows
     * by less than its distance from the centre.
     *
     * @param x where the point is at the first time, in px of the sensor
     */
    public double mostSpeed(double x, double y, long fromUs, long untilUs) {
        double dt = (fromUs - referenceUs) * 1e-6;
        double rx = x - centreX - (vx + 0.5 * ax * dt) * dt;
        double ry = y - centreY - (vy + 0.5 * ay * dt) * dt;
        double farthest = 2 * Math.sqrt(rx * rx + ry * ry);
        double longest = Math.max(Math.abs(dt), Math.abs(untilUs - referenceUs) * 1e-6);
        return Math.sqrt(vx * vx + vy * vy) + Math.sqrt(ax * ax + ay * ay) * longest
            + (Math.abs(omega) + Math.abs(alpha) * longest + Math.abs(growth) + Math.abs(growthChange) * longest)
            * farthest + deformation.mostSpeed(farthest);
    }

    /**
     * Speed in px/s, root of the mean square over points whose distance from the centre has that of radius, but for
     * what perspective adds.
     */
    public double speed(double radius) {
        return Math.sqrt(vx * vx + vy * vy
            + (omega * omega + growth * growth + deformation.square()) * radius * radius);
    }

    /**
     * Speed in px/s at which what moves like this leaves what moves like another motion of the same time, root of the
     * mean square over points whose distance from the centre of this one has that of radius; but for deformation, which
     * no contour follows.
     */
    public double speedFrom(Motion other, double radius) {
        double rx = centreX - other.centreX;
        double ry = centreY - other.centreY;
        double dvx = vx - other.vx - other.growth * rx + other.omega * ry;
        double dvy = vy - other.vy - other.growth * ry - other.omega * rx;
        double turn = (omega - other.omega) * radius;
        double grow = (growth - other.growth) * radius;
        return Math.sqrt(dvx * dvx + dvy * dvy + turn * turn + grow * grow);
    }
}
