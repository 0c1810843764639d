package io.github.sofas.flow.fit;

import java.util.Arrays;

/**
 * How the picture of a structure's events changes when it moves right, moves down, turns and grows, and how far these
 * changes are alike: the structure tensor of all four. Ours, because each parameter of the motion is measured by
 * itself, and an arc that slides along itself looks as if it turned about its middle: without the tensor, a disc found
 * in two arcs stayed two that turn. Only what shows of a parameter beyond the others is known of it.
 *
 * <p>A mean over the measurements of late, because one sample of events is a rough picture. The mean is of what shows
 * in each picture, not of the pictures: turning about a centre beside that of a disc is a shift, in another direction
 * for each such centre, and a mean of pictures hides that. The disc would seem to turn.
 */
final class StructureTensor {
    /** Number of the turning among the four parameters, and of the growth. */
    static final int TURN = 2;
    static final int GROW = 3;
    private static final int N = 4;
    /** Share of the changes that may be noise, so that parameters of which nothing shows take nothing away. */
    private static final double NOISE = 0.005;
    /** Part of a new picture that is taken over. */
    private static final double GAIN = 0.5;
    /** Share of all that velocities change which along either axis may be noise: along an edge nothing is known. */
    private static final double FLAT = 0.1;

    private final double[][] sum = new double[N][N];
    /** What shows of each parameter as a share of all that shows, and what of that is its own: means of late. */
    private final double[] shows = new double[N];
    private final double[] own = new double[N];
    /** The velocity that changes the picture as a growth does, in px/s per px/s at the radius: a mean of late. */
    private double growsFromX;
    private double growsFromY;
    private boolean known;
    // by how much each parameter changes a place of the one picture, and of the other
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
     * Adds a place of the picture, seen twice by events of their own, so that the noise of either has no part.
     *
     * @param gx slope of the one picture to the right, and gy downwards
     * @param hx slope of the other picture to the right, and hy downwards
     * @param x column from the centre of turning and growth, in radii of the structure, and y the row
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

    /** Takes the picture into the mean, unless there is nothing but noise. */
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

    /** Takes over from the picture the velocity that explains the most of what growth changes. */
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

    /** Takes over from the picture what shows of a parameter, and what of that no other can explain. */
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

    /** What shows of a parameter that none of the others can explain, as a share of what shows of it: 0 to 1. */
    double own(int parameter) {
        return known ? own[parameter] / shows[parameter] : 0;
    }

    /**
     * Column, from the centre and in radii, of the place from which a growth changes the picture least as a velocity
     * does; from another place, the two are taken for each other.
     */
    double growsFromX() {
        return growsFromX;
    }

    /** The same, the row. */
    double growsFromY() {
        return growsFromY;
    }

    /** Takes away from all others what a parameter explains of them: a step of Gauss's elimination. */
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
