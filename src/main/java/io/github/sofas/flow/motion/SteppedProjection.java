package io.github.sofas.flow.motion;

/**
 * Projects events along a motion in steps of time. Within a step, the motion proceeds by a small part of a pixel, and
 * all events are turned, scaled and shifted alike, as in the middle of the step. A motion with rotation and
 * acceleration thus costs its arithmetic once per step instead of once per event. Ours, because events come in order of
 * time.
 *
 * <p>The deformation of the motion is left out.
 */
public final class SteppedProjection {
    private final Motion motion = new Motion();
    private long stepUs;
    private long fromUs;
    private long untilUs;
    private double cos;
    private double sin;
    private double shiftX;
    private double shiftY;

    /**
     * Begins with a motion.
     *
     * @param spanUs greatest time, in µs, between an event and the reference of the motion
     * @param radius greatest distance, in px, of an event from the centre of the motion
     * @param stepPx travel, in px, that one step may span
     */
    public void begin(Motion along, long spanUs, double radius, double stepPx) {
        motion.copyFrom(along);
        double span = spanUs * 1e-6;
        double gained = Math.sqrt(motion.ax * motion.ax + motion.ay * motion.ay) * span;
        double turning = Math.abs(motion.omega) + Math.abs(motion.alpha) * span + Math.abs(motion.growth)
            + Math.abs(motion.growthChange) * span;
        double pxPerS = Math.sqrt(motion.vx * motion.vx + motion.vy * motion.vy) + gained + turning * radius;
        stepUs = (long) Math.min(1 + spanUs, stepPx / Math.max(pxPerS, 1e-3) * 1e6);
        fromUs = 0;
        untilUs = -1;
    }

    /** Advances to the time of the next event; returns whether that took another step. */
    public boolean advance(long timeUs) {
        if (timeUs <= untilUs && timeUs >= fromUs) {
            return false;
        }
        fromUs = timeUs;
        untilUs = timeUs + stepUs;
        step((timeUs + stepUs / 2 - motion.referenceUs) * 1e-6);
        return true;
    }

    /** Goes to an exact time, for a single projection that must not be off by half a step. */
    public void goTo(long timeUs) {
        fromUs = timeUs;
        untilUs = timeUs;
        step((timeUs - motion.referenceUs) * 1e-6);
    }

    private void step(double dt) {
        double turn = (motion.omega + 0.5 * motion.alpha * dt) * dt;
        double grown = (motion.growth + 0.5 * motion.growthChange * dt) * dt;
        // sine, cosine and the exponential to a few parts in 10,000 of half a radian, and of a growth by a half
        double square = turn * turn;
        double scale = 1 - grown * (1 - grown * (0.5 - grown * (1.0 / 6 - grown / 24)));
        sin = scale * turn * (1 - square / 6 * (1 - square / 20));
        cos = scale * (1 - 0.5 * square * (1 - square / 12));
        double centreX = motion.centreX + (motion.vx + 0.5 * motion.ax * dt) * dt;
        double centreY = motion.centreY + (motion.vy + 0.5 * motion.ay * dt) * dt;
        shiftX = motion.centreX - cos * centreX - sin * centreY;
        shiftY = motion.centreY - cos * centreY + sin * centreX;
    }

    /** Column, in px, of an event of this step, projected to the reference time of the motion. */
    public double x(int eventX, int eventY) {
        return cos * eventX + sin * eventY + shiftX;
    }

    /** Row of the projected event, likewise. */
    public double y(int eventX, int eventY) {
        return cos * eventY - sin * eventX + shiftY;
    }

    /** Inverse projection: column, in px, of an event of this step that is projected to (x, y). */
    public double backX(double x, double y) {
        return (cos * (x - shiftX) - sin * (y - shiftY)) / (cos * cos + sin * sin);
    }

    /** Inverse projection: row of that event, in px. */
    public double backY(double x, double y) {
        return (sin * (x - shiftX) + cos * (y - shiftY)) / (cos * cos + sin * sin);
    }

    /** Cosine of the angle by which this step turns, times the factor by which it scales. */
    public double cos() {
        return cos;
    }

    /** Sine of that angle, times the same factor. */
    public double sin() {
        return sin;
    }

    /** Shift of the origin to the right by this step, in px. */
    public double shiftX() {
        return shiftX;
    }

    /** Shift of the origin downwards, likewise. */
    public double shiftY() {
        return shiftY;
    }
}
