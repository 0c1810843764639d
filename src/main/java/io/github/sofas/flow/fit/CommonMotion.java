package io.github.sofas.flow.fit;

import io.github.sofas.flow.motion.Motion;

/**
 * The motion that serves two structures best, were they one rigid body: that by which their metrics lose least. Ours,
 * because the two ends of a body that turns have two velocities, and the two halves of a bar opposite ones: by a
 * common velocity alone a rotating bar fell into four segments.
 *
 * <p>With velocities vi of their centres, losses Li by other velocities, and li by other rotations, it is the v and
 * omega about the point between them that make the sum over both of (v + omega x r - vi)' Li (v + omega x r - vi) +
 * li (omega - omegai)² least: three linear equations.
 */
public final class CommonMotion {
    private final Motion first = new Motion();
    private final Motion second = new Motion();
    private final Motion motion = new Motion();
    private double lost;

    // the equations, symmetric: xx vx + xy vy + xw omega = bx, and so on
    private double xx;
    private double xy;
    private double xw;
    private double yy;
    private double yw;
    private double ww;
    private double bx;
    private double by;
    private double bw;

    /**
     * Fits it.
     *
     * @param a motion of the one structure, b of the other; they stay as they are
     * @return whether the two together know every part of it; if not, it is the first one's
     */
    public boolean fit(Motion a, MotionLoss lossA, Motion b, MotionLoss lossB, long nowUs) {
        load(a, lossA, b, lossB, nowUs);
        return solve(lossA, lossB);
    }

    /** The same for two structures of which each keeps its own rotation, or whose rotation is not known yet. */
    public boolean fitVelocity(Motion a, MotionLoss lossA, Motion b, MotionLoss lossB, long nowUs) {
        load(a, lossA, b, lossB, nowUs);
        // the third equation is omega = 0, and neither counts its own
        xw = 0;
        yw = 0;
        ww = 1;
        bw = 0;
        double own = first.omega;
        first.omega = 0;
        second.omega = 0;
        boolean known = solve(lossA, lossB);
        motion.omega = own;
        return known;
    }

    private void load(Motion a, MotionLoss lossA, Motion b, MotionLoss lossB, long nowUs) {
        first.copyFrom(a);
        first.moveReference(nowUs);
        second.copyFrom(b);
        second.moveReference(nowUs);
        motion.copyFrom(first);
        motion.centreX = (first.centreX + second.centreX) / 2;
        motion.centreY = (first.centreY + second.centreY) / 2;
        clear();
        add(first, lossA);
        add(second, lossB);
    }

    private boolean solve(MotionLoss lossA, MotionLoss lossB) {
        double cxx = yy * ww - yw * yw;
        double cxy = xw * yw - xy * ww;
        double cxw = xy * yw - xw * yy;
        double determinant = xx * cxx + xy * cxy + xw * cxw;
        if (!(determinant > 0)) {
            motion.copyFrom(first);
            lost = Double.POSITIVE_INFINITY;
            return false;
        }
        double cyy = xx * ww - xw * xw;
        double cyw = xy * xw - xx * yw;
        double cww = xx * yy - xy * xy;
        motion.vx = (cxx * bx + cxy * by + cxw * bw) / determinant;
        motion.vy = (cxy * bx + cyy * by + cyw * bw) / determinant;
        motion.omega = (cxw * bx + cyw * by + cww * bw) / determinant;
        lost = Math.max(shareLost(first, lossA), shareLost(second, lossB));
        return true;
    }

    private void clear() {
        xx = 0;
        xy = 0;
        xw = 0;
        yy = 0;
        yw = 0;
        ww = 0;
        bx = 0;
        by = 0;
        bw = 0;
    }

    /** Adds what one structure knows; its centre's velocity is (vx - omega ry, vy + omega rx). */
    private void add(Motion its, MotionLoss loss) {
        double rx = its.centreX - motion.centreX;
        double ry = its.centreY - motion.centreY;
        double turnedX = loss.xy * rx - loss.xx * ry;
        double turnedY = loss.yy * rx - loss.xy * ry;
        xx += loss.xx;
        xy += loss.xy;
        xw += turnedX;
        yy += loss.yy;
        yw += turnedY;
        ww += turnedY * rx - turnedX * ry + loss.turn;
        double pullX = loss.xx * its.vx + loss.xy * its.vy;
        double pullY = loss.xy * its.vx + loss.yy * its.vy;
        bx += pullX;
        by += pullY;
        bw += pullY * rx - pullX * ry + loss.turn * its.omega;
    }

    private double shareLost(Motion its, MotionLoss loss) {
        double rx = its.centreX - motion.centreX;
        double ry = its.centreY - motion.centreY;
        return loss.of(motion.vx - motion.omega * ry - its.vx, motion.vy + motion.omega * rx - its.vy,
            motion.omega - its.omega) / loss.metric;
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
