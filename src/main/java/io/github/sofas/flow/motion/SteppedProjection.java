package io.github.sofas.flow.motion;

/**
 * Projects events along a motion, step by step: in the time in which the motion goes on by a small part of a pixel all
 * events are turned, scaled and shifted alike, as in the middle of that time. What a turning, accelerating motion costs
 * is spent once per step and not once per event. Ours, because events come in order of time.
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
     * @param spanUs greatest time between an event and the motion's reference
     * @param radius greatest distance of an event from the centre of the motion in px
     * @param stepPx part of a pixel that a step may take
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

    /** Goes on to the time of the next event; returns whether that takes another step. */
    public boolean advance(long timeUs) {
        if (timeUs <= untilUs && timeUs >= fromUs) {
            return false;
        }
        fromUs = timeUs;
        untilUs = timeUs + stepUs;
        step((timeUs + stepUs / 2 - motion.referenceUs) * 1e-6);
        return true;
    }

    /** Goes to a time exactly, for what happens once and must not drift by half a step. */
    public void goTo(long timeUs) {
        fromUs = timeUs;
        untilUs = timeUs;
        step((timeUs - motion.referenceUs) * 1e-6);
    }

    private void step(double dt) {
        double turn = (motion.omega + 0.5 * motion.alpha * dt) * dt;
        double grown = (motion.growth + 0.5 * motion.growthChange * dt) * dt;
        // sine, cosine and the exponential to a few parts in 10,000 of half a turn, and of a growth by a half
        double square = turn * turn;
        double scale = 1 - grown * (1 - grown * (0.5 - grown * (1.0 / 6 - grown / 24)));
        sin = scale * turn * (1 - square / 6 * (1 - square / 20));
        cos = scale * (1 - 0.5 * square * (1 - square / 12));
        double centreX = motion.centreX + (motion.vx + 0.5 * motion.ax * dt) * dt;
        double centreY = motion.centreY + (motion.vy + 0.5 * motion.ay * dt) * dt;
        shiftX = motion.centreX - cos * centreX - sin * centreY;
        shiftY = motion.centreY - cos * centreY + sin * centreX;
    }

    /** Column at the motion's reference of an event of this time, in px. */
    public double x(int eventX, int eventY) {
        return cos * eventX + sin * eventY + shiftX;
    }

    /** The same, the row. */
    public double y(int eventX, int eventY) {
        return cos * eventY - sin * eventX + shiftY;
    }

    /** Column that an event of this time has whose place at the motion's reference is (x, y), in px. */
    public double backX(double x, double y) {
        return (cos * (x - shiftX) - sin * (y - shiftY)) / (cos * cos + sin * sin);
    }

    /** The same, the row. */
    public double backY(double x, double y) {
        return (sin * (x - shiftX) + cos * (y - shiftY)) / (cos * cos + sin * sin);
    }

    /** Cosine of the angle that this step turns by, times what it scales by. */
    public double cos() {
        return cos;
    }

    /** The same, the sine. */
    public double sin() {
        return sin;
    }

    /** Way that this step shifts the origin to the right, in px. */
    public double shiftX() {
        return shiftX;
    }

    /** The same, downwards. */
    public double shiftY() {
        return shiftY;
    }
}
