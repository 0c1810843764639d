package io.github.sofas.flow.motion;

/**
 * Projects events that come in order of time along a motion, step by step: in the time in which the motion goes on by a
 * small part of a pixel all events are turned and shifted alike, as in the middle of that time. What a turning,
 * accelerating motion costs is spent once a step and not once an event.
 */
public final class SteppedProjection {
    private final Motion motion = new Motion();
    private long stepUs;
    private long untilUs;
    private double cos;
    private double sin;
    private double shiftX;
    private double shiftY;

    /**
     * Begins with the oldest event.
     *
     * @param spanUs greatest time between an event and the motion's reference
     * @param radius greatest distance of an event from the centre of the motion in px
     * @param stepPx part of a pixel that a step may take
     */
    public void begin(Motion along, long spanUs, double radius, double stepPx) {
        motion.copyFrom(along);
        double gained = StrictMath.hypot(motion.ax, motion.ay) * spanUs * 1e-6;
        double pxPerS = StrictMath.hypot(motion.vx, motion.vy) + gained + Math.abs(motion.omega) * radius;
        stepUs = (long) Math.min(1 + spanUs, stepPx / Math.max(pxPerS, 1e-3) * 1e6);
        untilUs = Long.MIN_VALUE;
    }

    /** Goes on to the time of the next event. */
    public void advance(long timeUs) {
        if (timeUs > untilUs) {
            untilUs = timeUs + stepUs;
            step((timeUs + stepUs / 2 - motion.referenceUs) * 1e-6);
        }
    }

    /** The same as {@link Motion#project}, as the coefficients of a rotation and a shift. */
    private void step(double dt) {
        double turn = motion.omega * dt;
        // sine and 1 - cosine to a few parts in 10,000 of half a turn in a window
        double square = turn * turn;
        sin = turn * (1 - square / 6);
        cos = 1 - 0.5 * square * (1 - square / 12);
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
}
