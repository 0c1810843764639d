package io.github.sofas.flow.fit;

import java.util.Arrays;

/**
 * The structure tensor of four motions: how the picture of a structure's events changes when it moves right, moves
 * down, turns and grows, and how far these changes are alike. Ours, because each parameter of the motion is measured
 * separately, and an arc that slides along itself looks as if it turned about its middle. Without the tensor, a disc
 * that was found as two arcs stayed two structures that turn. A parameter is known only as far as it shows beyond the
 * other parameters.
 *
 * <p>The results are means over recent measurements, because one sample of events is a rough picture. Each mean is over
 * what shows in the pictures, not over the pictures. Rotation about a centre beside that of a disc is a shift, in
 * another direction for each such centre. A mean of pictures would hide that, and the disc would seem to turn.
 */
final class StructureTensor {
    /** Index of the rotation among the four parameters, and of the growth. */
    static final int TURN = 2;
    static final int GROW = 3;
    private static final int N = 4;
    /** Share of the changes that may be noise, so that parameters that do not show take nothing from the others. */
    private static final double NOISE = 0.005;
    /** Part of a new picture that is adopted. */
    private static final double GAIN = 0.5;
    /** Share of all changes by velocities that may be noise along either axis: along an edge nothing is known. */
    private static final double FLAT = 0.1;

    private final double[][] sum = new double[N][N];
    /** Share of each parameter in all that shows, and the part that is its own: means over recent pictures. */
    private final double[] shows = new double[N];
    private final double[] own = new double[N];
    /** The velocity that changes the picture as growth does, in px/s per px/s at the radius: a recent mean. */
    private double growsFromX;
    private double growsFromY;
    private boolean known;
    // changes of a place by each parameter, in the one picture and in the other
    private final double[] one = new double[N];
    private final double[] other = new double[N];
    private final double[][] left = new double[N][N];

    /** Forgets all pictures. */
    void restart() {
        known = false;
        growsFromX = 0;
        growsFromY = 0;
    }

    /** Begins with a new picture. */
    void begin() {
        for (double[] row : sum) {
            Arrays.fill(row, 0);
        }
    }

    /**
     * Adds a place of the picture. Two pictures of separate events show it, so that the noise of neither contributes.
     *
     * @param gx slope of the one picture to the right, and gy downwards
     * @param hx slope of the other picture to the right, and hy downwards
     * @param x column from the centre of rotation and growth, in radii of the structure, and y the row
     */
    void add(double gx, double gy, double hx, double hy, double x, double y) {
        load(one, gx, gy, x, y);
        load(other, hx, hy, x, y);
        for (int i = 0; i < N; i++) {
            for (int j = 0; j < N; j++) {
                sum[i][j] += one[i] * other[j];
            }
        }
    }

    private static void load(double[] change, double slopeX, double slopeY, double x, double y) {
        change[0] = slopeX;
        change[1] = slopeY;
        change[TURN] = slopeY * x - slopeX * y;
        change[GROW] = slopeX * x + slopeY * y;
    }

    /** Adds the picture to the means, unless it holds nothing but noise. */
    void end() {
        double all = 0;
        for (int i = 0; i < N; i++) {
            all += sum[i][i];
        }
        if (!(all > 0)) {
            return;
        }
        double gain = known ? GAIN : 1;
        known = true;
        take(TURN, all, gain);
        take(GROW, all, gain);
        takeGrowsFrom(gain);
    }

    /** Updates the velocity that explains the most of the change by growth. */
    private void takeGrowsFrom(double gain) {
        double noise = FLAT * Math.max(0, sum[0][0] + sum[1][1]);
        double xx = Math.max(0, sum[0][0]) + noise;
        double yy = Math.max(0, sum[1][1]) + noise;
        double xy = (sum[0][1] + sum[1][0]) / 2;
        double x = (sum[0][GROW] + sum[GROW][0]) / 2;
        double y = (sum[1][GROW] + sum[GROW][1]) / 2;
        double det = xx * yy - xy * xy;
        if (det > 0) {
            growsFromX += gain * ((yy * x - xy * y) / det - growsFromX);
            growsFromY += gain * ((xx * y - xy * x) / det - growsFromY);
        }
    }

    /** Updates how much of a parameter shows, and how much of that no other parameter can explain. */
    private void take(int parameter, double all, double gain) {
        for (int i = 0; i < N; i++) {
            for (int j = 0; j < N; j++) {
                left[i][j] = (sum[i][j] + sum[j][i]) / 2 / all;
            }
            left[i][i] = Math.max(0, left[i][i]) + NOISE;
        }
        double shown = left[parameter][parameter];
        for (int i = 0; i < N; i++) {
            if (i != parameter && left[i][i] > 0) {
                explain(i);
            }
        }
        double ownShown = Math.max(0, Math.min(shown, left[parameter][parameter] - NOISE));
        shows[parameter] += gain * (shown - shows[parameter]);
        own[parameter] += gain * (ownShown - own[parameter]);
    }

    /**
     * The part of a parameter that none of the others can explain, as a share of what shows of the parameter: 0 to 1.
     */
    double own(int parameter) {
        return known ? own[parameter] / shows[parameter] : 0;
    }

    /**
     * Column, from the centre and in radii, of the place from which growth and velocity change the picture least alike;
     * from any other place, one is mistaken for the other.
     */
    double growsFromX() {
        return growsFromX;
    }

    /** The same, the row. */
    double growsFromY() {
        return growsFromY;
    }

    /** Removes from all other parameters what one parameter explains of them: a step of Gaussian elimination. */
    private void explain(int by) {
        for (int i = 0; i < N; i++) {
            if (i != by) {
                double factor = left[i][by] / left[by][by];
                for (int j = 0; j < N; j++) {
                    left[i][j] -= factor * left[by][j];
                }
            }
        }
    }
}
