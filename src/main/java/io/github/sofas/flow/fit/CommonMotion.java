package io.github.sofas.flow.fit;

import io.github.sofas.flow.motion.Motion;

/**
 * The motion that serves two structures best, were they one body: that by which their metrics lose least. Ours, because
 * the two ends of a body that turns have two velocities, and so have two parts of what comes nearer.
 *
 * <p>Rotation, growth and deformation are those of the one that knows them better. Any two velocities agree with some
 * rotation and growth, so that these are no unknowns. With velocities vi of their centres and losses Li by other
 * velocities, the velocity v of the point between them is that which makes the sum over both of (v + omega x r +
 * growth r - vi)' Li (v + omega x r + growth r - vi) least, with what the deformation adds. There Li has a little of
 * itself all round, so that no velocity is made up along edges.
 */
public final class CommonMotion {
    /**
     * Share of what is known of a structure's velocity by which it is held in every direction: two edges that are all
     * but parallel have a velocity in common, however fast each is, but far along themselves, where neither shows it.
     */
    private static final double HELD = 0.01;

    private final Motion first = new Motion();
    private final Motion second = new Motion();
    private final Motion middle = new Motion();
    private final Motion motion = new Motion();
    private double lost;

    // two linear equations: what is known of both velocities, and that times the common velocity that either asks for
    private double xx;
    private double xy;
    private double yy;
    private double bx;
    private double by;

    /**
     * Fits it.
     *
     * @param one motion of the one structure, other of the other; they stay as they are
     * @param timeUs when the two are to move alike
     * @return whether the two together know all of the velocity; if not, the motion is the first one's
     */
    public boolean fit(Motion one, MotionLoss lossOne, Motion other, MotionLoss lossOther, long timeUs) {
        begin(one, lossOne, other, lossOther, timeUs);
        return fitVelocity(lossOne, lossOther);
    }

    /**
     * The same of two edges that are known to be of one body, each of which may show nothing of its rotation: that is
     * the one by which their velocities differ across the line between them.
     */
    public boolean fitEdges(Motion one, MotionLoss lossOne, Motion other, MotionLoss lossOther, long timeUs) {
        begin(one, lossOne, other, lossOther, timeUs);
        double x = second.centreX - first.centreX;
        double y = second.centreY - first.centreY;
        double apart = x * x + y * y;
        if (apart > 0) {
            motion.omega = (x * (second.vy - first.vy) - y * (second.vx - first.vx)) / apart;
        }
        return fitVelocity(lossOne, lossOther);
    }

    /** Begins with rotation, deformation and growth of the one that knows them better, in the middle between them. */
    private void begin(Motion one, MotionLoss lossOne, Motion other, MotionLoss lossOther, long timeUs) {
        first.copyFrom(one);
        first.moveReference(timeUs);
        second.copyFrom(other);
        second.moveReference(timeUs);
        motion.copyFrom(first);
        motion.centreX = (first.centreX + second.centreX) / 2;
        motion.centreY = (first.centreY + second.centreY) / 2;
        middle.copyFrom(lossOther.turn > lossOne.turn ? second : first);
        middle.moveCentre(motion.centreX, motion.centreY);
        motion.omega = middle.omega;
        motion.growth = middle.growth;
        motion.deformation.copyFrom(middle.deformation);
        if (motion.deformation.isNone()) {
            motion.growth = lossOther.grow > lossOne.grow ? second.growth : first.growth;
        }
    }

    private boolean fitVelocity(MotionLoss lossOne, MotionLoss lossOther) {
        xx = 0;
        xy = 0;
        yy = 0;
        bx = 0;
        by = 0;
        add(first, lossOne);
        add(second, lossOther);
        double det = xx * yy - xy * xy;
        if (!(det > 0)) {
            motion.copyFrom(first);
            lost = Double.POSITIVE_INFINITY;
            return false;
        }
        motion.vx = (yy * bx - xy * by) / det;
        motion.vy = (xx * by - xy * bx) / det;
        lost = Math.max(shareLost(first, lossOne), shareLost(second, lossOther));
        return true;
    }

    /** Velocity to the right by which a structure's centre moves beside the point between the two. */
    private double besideX(Motion its) {
        double rx = its.centreX - motion.centreX;
        double ry = its.centreY - motion.centreY;
        return motion.growth * rx - motion.omega * ry + motion.deformation.vx(rx, ry);
    }

    /** The same downwards. */
    private double besideY(Motion its) {
        double rx = its.centreX - motion.centreX;
        double ry = its.centreY - motion.centreY;
        return motion.growth * ry + motion.omega * rx + motion.deformation.vy(rx, ry);
    }

    /** Adds what one structure knows. */
    private void add(Motion its, MotionLoss loss) {
        double held = HELD * (loss.xx + loss.yy);
        double vx = its.vx - besideX(its);
        double vy = its.vy - besideY(its);
        xx += loss.xx + held;
        xy += loss.xy;
        yy += loss.yy + held;
        bx += (loss.xx + held) * vx + loss.xy * vy;
        by += loss.xy * vx + (loss.yy + held) * vy;
    }

    private double shareLost(Motion its, MotionLoss loss) {
        double rx = its.centreX - motion.centreX;
        double ry = its.centreY - motion.centreY;
        return loss.of(motion.vx + besideX(its) - its.vx, motion.vy + besideY(its) - its.vy,
            motion.omega + motion.deformation.omegaAt(rx, ry) - its.omega,
            motion.growth + motion.deformation.growthAt(rx, ry) - its.growth) / loss.metric;
    }

    /** Whether these make the velocities of the two centres differ by more than a share of the speed. */
    public boolean turnsOrGrows(double share) {
        double x = besideX(first) - besideX(second);
        double y = besideY(first) - besideY(second);
        return x * x + y * y > share * share * (motion.vx * motion.vx + motion.vy * motion.vy);
    }

    /** The motion, at the time it was fitted for. */
    public Motion motion() {
        return motion;
    }

    /** The greater of the shares of its metric that either structure loses by it. */
    public double lost() {
        return lost;
    }
}
