package io.github.sofas.flow.fit;

import io.github.sofas.flow.motion.Motion;
import java.util.Arrays;

/**
 * The motion that serves two structures best, were they one body: that by which their metrics lose least. Ours, because
 * the two ends of a body that turns have two velocities, and so have two parts of what comes nearer: by a common
 * velocity alone a rotating bar fell into four segments.
 *
 * <p>With velocities vi of their centres, losses Li by other velocities, li by other rotations and gi by other growths,
 * it is the v, omega and growth about the point between them that make the sum over both of
 * (v + omega x r + growth r - vi)' Li (v + omega x r + growth r - vi) + li (omega - omegai)² + gi (growth - growthi)²
 * least: four linear equations. There Li has a little of itself all round, so that no velocity is made up along edges.
 */
public final class CommonMotion {
    private static final int N = 4;
    /**
     * Share of what is known of a structure's velocity by which it is held in every direction: two edges that are all
     * but parallel have a velocity in common, however fast each is, but far along themselves, where neither shows it.
     */
    private static final double HELD = 0.01;

    private final Motion first = new Motion();
    private final Motion second = new Motion();
    private final Motion motion = new Motion();
    private double lost;
    private double leastShown;

    // the equations, a row each, of (vx, vy, omega, growth), and their right sides
    private final double[][] a = new double[N][N];
    private final double[] b = new double[N];
    private final double[] solution = new double[N];
    // of the structure that is added: how its centre's velocity follows from each unknown
    private final double[] toVx = new double[N];
    private final double[] toVy = new double[N];

    /**
     * Fits it.
     *
     * @param one motion of the one structure, other of the other; they stay as they are
     * @return whether the two together know every part of it; if not, it is the first one's
     */
    public boolean fit(Motion one, MotionLoss lossOne, Motion other, MotionLoss lossOther, long nowUs) {
        load(one, other, nowUs);
        add(first, lossOne);
        add(second, lossOther);
        if (!(lossOne.turn > 0) && !(lossOther.turn > 0)) {
            pin(2, 0);
        }
        if (!(lossOne.grow > 0) && !(lossOther.grow > 0)) {
            pin(3, 0);
        }
        return finish(lossOne, lossOther);
    }

    /** The same with the rotation and the growth of the one that knows them better: only the velocity is fitted. */
    public boolean fitVelocity(Motion one, MotionLoss lossOne, Motion other, MotionLoss lossOther, long nowUs) {
        load(one, other, nowUs);
        add(first, lossOne);
        add(second, lossOther);
        pin(2, lossOther.turn > lossOne.turn ? second.omega : first.omega);
        pin(3, lossOther.grow > lossOne.grow ? second.growth : first.growth);
        return finish(lossOne, lossOther);
    }

    private boolean finish(MotionLoss lossOne, MotionLoss lossOther) {
        if (!solve()) {
            motion.copyFrom(first);
            lost = Double.POSITIVE_INFINITY;
            leastShown = 0;
            return false;
        }
        motion.vx = solution[0];
        motion.vy = solution[1];
        motion.omega = solution[2];
        motion.growth = solution[3];
        lost = Math.max(shareLost(first, lossOne), shareLost(second, lossOther));
        leastShown = Math.min(shareShown(lossOne), shareShown(lossOther));
        return true;
    }

    private void load(Motion one, Motion other, long nowUs) {
        first.copyFrom(one);
        first.moveReference(nowUs);
        second.copyFrom(other);
        second.moveReference(nowUs);
        motion.copyFrom(first);
        motion.centreX = (first.centreX + second.centreX) / 2;
        motion.centreY = (first.centreY + second.centreY) / 2;
        for (double[] row : a) {
            Arrays.fill(row, 0);
        }
        Arrays.fill(b, 0);
    }

    private void relate(Motion its) {
        double rx = its.centreX - motion.centreX;
        double ry = its.centreY - motion.centreY;
        toVx[0] = 1;
        toVx[1] = 0;
        toVx[2] = -ry;
        toVx[3] = rx;
        toVy[0] = 0;
        toVy[1] = 1;
        toVy[2] = rx;
        toVy[3] = ry;
    }

    /** Adds what one structure knows. */
    private void add(Motion its, MotionLoss loss) {
        relate(its);
        double held = HELD * (loss.xx + loss.yy);
        double xx = loss.xx + held;
        double yy = loss.yy + held;
        for (int i = 0; i < N; i++) {
            double lx = xx * toVx[i] + loss.xy * toVy[i];
            double ly = loss.xy * toVx[i] + yy * toVy[i];
            for (int j = 0; j < N; j++) {
                a[i][j] += lx * toVx[j] + ly * toVy[j];
            }
            b[i] += lx * its.vx + ly * its.vy;
        }
        a[2][2] += loss.turn;
        b[2] += loss.turn * its.omega;
        a[3][3] += loss.grow;
        b[3] += loss.grow * its.growth;
    }

    /** Gives an unknown a value. */
    private void pin(int i, double value) {
        for (int j = 0; j < N; j++) {
            b[j] -= a[j][i] * value;
            a[i][j] = 0;
            a[j][i] = 0;
        }
        a[i][i] = 1;
        b[i] = value;
    }

    /** Solves the equations by Gauss's elimination, whose pivots are positive where every part is known. */
    private boolean solve() {
        for (int i = 0; i < N; i++) {
            if (!(a[i][i] > 0)) {
                return false;
            }
            for (int k = i + 1; k < N; k++) {
                double factor = a[k][i] / a[i][i];
                for (int j = i; j < N; j++) {
                    a[k][j] -= factor * a[i][j];
                }
                b[k] -= factor * b[i];
            }
        }
        for (int i = N - 1; i >= 0; i--) {
            double sum = b[i];
            for (int j = i + 1; j < N; j++) {
                sum -= a[i][j] * solution[j];
            }
            solution[i] = sum / a[i][i];
        }
        return true;
    }

    private double shareLost(Motion its, MotionLoss loss) {
        relate(its);
        double vx = -its.vx;
        double vy = -its.vy;
        for (int i = 0; i < N; i++) {
            vx += toVx[i] * solution[i];
            vy += toVy[i] * solution[i];
        }
        return loss.of(vx, vy, motion.omega - its.omega, motion.growth - its.growth) / loss.metric;
    }

    private double shareShown(MotionLoss loss) {
        return loss.of(0, 0, motion.omega, motion.growth) / loss.metric;
    }

    /** The motion, at the time it was fitted for. */
    public Motion motion() {
        return motion;
    }

    /** The greater of the shares of its metric that either structure loses by it. */
    public double lost() {
        return lost;
    }

    /**
     * The lesser of the shares of its metric that either structure would lose without the common rotation and growth,
     * about its own centre: any two velocities agree with some rotation and growth, which is evidence only where each
     * structure shows its own part of it.
     */
    public double leastShown() {
        return leastShown;
    }
}
