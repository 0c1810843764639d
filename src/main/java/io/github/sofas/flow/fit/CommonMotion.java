package io.github.sofas.flow.fit;

import io.github.sofas.flow.motion.Motion;

/**
 * The motion that suits two structures best if they are one body: the one by which their metrics lose least. Ours,
 * because the two ends of a turning body have two velocities, and so have two parts of an approaching body.
 *
 * <p>Rotation, growth and deformation are those of the structure that knows them better. They are no unknowns, because
 * any two velocities agree with some rotation and growth. The fit determines the velocity v of the point between the
 * structures. With the velocities vi of their centres and their losses Li by other velocities, v minimises the sum over
 * both of (v + omega x r + growth r - vi)' Li (v + omega x r + growth r - vi), where the deformation adds its part. Li
 * includes a little of itself in every direction, so that no velocity is invented along edges.
 */
public final class CommonMotion {
    /**
     * Share of what is known of a structure's velocity by which the velocity is held in every direction. Two almost
     * parallel edges always agree on some velocity, however fast each is, but on one far along the edges, where neither
     * shows it.
     */
    private static final double HELD = 0.01;

    private final Motion first = new Motion();
    private final Motion second = new Motion();
    private final Motion middle = new Motion();
    private final Motion motion = new Motion();
    private double lost;

    // two linear equations: the losses of both structures, and their products with the common velocity that each asks
    // for
    private double xx;
    private double xy;
    private double yy;
    private double bx;
    private double by;

    /**
     * Fits the common motion.
     *
     * @param one motion of the first structure, other that of the second; neither is changed
     * @param timeUs when the two are to move alike
     * @return whether the two together determine the whole velocity; if not, the motion is that of the first
     */
    public boolean fit(Motion one, MotionLoss lossOne, Motion other, MotionLoss lossOther, long timeUs) {
        begin(one, lossOne, other, lossOther, timeUs);
        return fitVelocity(lossOne, lossOther);
    }

    /**
     * The same for two edges that are known to belong to one body, where neither edge may show its rotation. The
     * rotation is then the one by which their velocities differ across the line between them.
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

    /**
     * Begins in the middle between the structures, with rotation, deformation and growth of the one that knows them
     * better.
     */
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

    /** Velocity to the right of a structure's centre, relative to the point between the two. */
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

    /** Adds the equations of one structure. */
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

    /**
     * Whether rotation, growth and deformation make the velocities of the two centres differ by more than a share of
     * the speed.
     */
    public boolean turnsOrGrows(double share) {
        double x = besideX(first) - besideX(second);
        double y = besideY(first) - besideY(second);
        return x * x + y * y > share * share * (motion.vx * motion.vx + motion.vy * motion.vy);
    }

    /** The motion, at the time it was fitted for. */
    public Motion motion() {
        return motion;
    }

    /** The greater of the shares of its metric that either structure loses by the common motion. */
    public double lost() {
        return lost;
    }
}
