package io.github.sofas.flow.motion;

/**
 * How a structure moves on the sensor: velocity, acceleration, rotation, growth and deformation about a centre that
 * moves along with the structure. Ours beyond the velocity of the paper, whose section Conclusion names acceleration
 * and rotation as fail cases.
 *
 * <p>A point at r from the centre c has the velocity v + omega x r + growth r, plus the velocity that the
 * {@link Deformation} adds. Let t0 be the reference time and dt = t - t0. Without deformation, the edge that fires an
 * event at u and time t is, at t0, at
 * exp(-growth dt - growthChange dt²/2) R(-omega dt - alpha dt²/2) (u - c - v dt - a dt²/2) + c
 * ({@link SteppedProjection}).
 */
public final class Motion {
    /** Reference time t0 in µs. */
    public long referenceUs;
    /** Velocity of the centre at t0 in px/s. */
    public double vx;
    public double vy;
    /** Acceleration of the centre in px/s². */
    public double ax;
    public double ay;
    /**
     * Rate at which the acceleration changes as the reference moves, in px/s³. Projections do not use the jerk: they
     * take the acceleration at the reference.
     */
    public double jerkX;
    public double jerkY;
    /** Rotation at t0 in rad/s; positive turns x towards y, clockwise as seen. */
    public double omega;
    /** Rate at which the rotation changes, in rad/s². */
    public double alpha;
    /** Rate at which alpha changes as the reference moves, in rad/s³; projections use neither this nor the jerk. */
    public double alphaChange;
    /**
     * Growth at t0 in 1/s, half the divergence of the flow. For an approaching object, 1/growth is the time to
     * contact.
     */
    public double growth;
    /** Rate at which the growth changes, in 1/s². */
    public double growthChange;
    /** How the flow departs from all of these, as that of a plane seen at a slant does; constant over time. */
    public final Deformation deformation = new Deformation();
    /** Centre of rotation, growth and deformation at t0 in px. */
    public double centreX;
    public double centreY;

    /** Starts anew with a steady velocity; the centre stays where it was. */
    public void set(long timeUs, double newVx, double newVy) {
        referenceUs = timeUs;
        vx = newVx;
        vy = newVy;
        omega = 0;
        growth = 0;
        deformation.clear();
        hold();
    }

    /** Keeps nothing but the rotation, as it is at the reference, about the centre where it is then. */
    public void turnInPlace() {
        double turning = omega;
        set(referenceUs, 0, 0);
        omega = turning;
    }

    /** Makes the motion steady as it is at the reference: neither velocity, nor rotation, nor growth changes. */
    public void hold() {
        ax = 0;
        ay = 0;
        jerkX = 0;
        jerkY = 0;
        alpha = 0;
        alphaChange = 0;
        growthChange = 0;
    }

    /** Copies another motion. */
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

    /** Moves the reference to another time; the motion stays the same. */
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
     * Moves the centre. The motion of every point stays the same, except for the radial acceleration that comes with
     * the square of the rotation and of the growth. Where the centre is a pixel off, that is noise.
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

    /** Moves first the reference, then the centre, to those of another motion. */
    public void follow(Motion other) {
        moveReference(other.referenceUs);
        moveCentre(other.centreX, other.centreY);
    }

    /** Velocity to the right, in px/s, of the structure at a point of the sensor and a time. */
    public float vxAt(int x, int y, long timeUs) {
        double dt = (timeUs - referenceUs) * 1e-6;
        double rx = x - centreX - vx * dt;
        double ry = y - centreY - vy * dt;
        return (float) (vx + ax * dt - (omega + alpha * dt) * ry + (growth + growthChange * dt) * rx
            + deformation.vx(rx, ry));
    }

    /** Velocity downwards, likewise. */
    public float vyAt(int x, int y, long timeUs) {
        double dt = (timeUs - referenceUs) * 1e-6;
        double rx = x - centreX - vx * dt;
        double ry = y - centreY - vy * dt;
        return (float) (vy + ay * dt + (omega + alpha * dt) * rx + (growth + growthChange * dt) * ry
            + deformation.vy(rx, ry));
    }

    /** Whether acceleration changes the velocity of a point by more than half of its speed in so many px of travel. */
    public boolean bendsWithin(double px, int x, int y, long timeUs) {
        double pointVx = vxAt(x, y, timeUs);
        double pointVy = vyAt(x, y, timeUs);
        return Math.hypot(ax, ay) * 2 * px > pointVx * pointVx + pointVy * pointVy;
    }

    /**
     * Upper bound, in px/s, of the speed of a point between two times. It holds as long as travel, rotation and growth
     * move the point by less than its distance from the centre.
     *
     * @param x column of the point at the first time, in px of the sensor
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
     * Root-mean-square speed, in px/s, of points whose root-mean-square distance from the centre is the radius; without
     * perspective.
     */
    public double speed(double radius) {
        return Math.sqrt(vx * vx + vy * vy
            + (omega * omega + growth * growth + deformation.square()) * radius * radius);
    }

    /**
     * Speed, in px/s, at which a structure with this motion departs from one with another motion of the same reference
     * time. It is the root mean square over points whose root-mean-square distance from the centre of this motion is
     * the radius. Deformation is left out, because no contour follows it.
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
