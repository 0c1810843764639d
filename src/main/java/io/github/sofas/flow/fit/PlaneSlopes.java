package io.github.sofas.flow.fit;

import java.util.Arrays;

/**
 * How the metric of a set of events changes with all parameters of the flow of a plane, to second order: its rise by
 * each parameter, and its loss by each pair of parameters. The parameters are velocities in px/s: that of the centre,
 * and those which rotation, growth, stretch, shear and perspective give a point one radius from the centre.
 */
final class PlaneSlopes {
    /** Parameters: velocity to the right and downwards, rotation, growth, and four of the deformation. */
    static final int COUNT = 8;
    static final int TURN = 2;
    static final int GROW = 3;
    static final int STRETCH = 4;
    static final int SHEAR = 5;
    static final int PERSPECTIVE_X = 6;
    static final int PERSPECTIVE_Y = 7;

    private double radius;
    private final double[] rise = new double[COUNT];
    private final double[][] loss = new double[COUNT][COUNT];
    /** Velocity that a unit of each parameter, except those of the centre, gives the place that is added. */
    private final double[] ux = new double[COUNT];
    private final double[] uy = new double[COUNT];

    /** Begins without events, for a structure with so many px of radius. */
    void begin(double structureRadius) {
        radius = structureRadius;
        Arrays.fill(rise, 0);
        for (double[] row : loss) {
            Arrays.fill(row, 0);
        }
    }

    /**
     * Adds a place.
     *
     * @param rx px from the centre to the right, and ry downwards
     * @param riseX rise of the metric there per px/s to the right, and riseY downwards
     * @param xx loss of the metric there per (px/s)²; xx, xy and yy are the entries of a symmetric matrix
     */
    void add(double rx, double ry, double riseX, double riseY, double xx, double xy, double yy) {
        flowAt(rx / radius, ry / radius);
        // the velocity of the centre moves all places alike
        rise[0] += riseX;
        rise[1] += riseY;
        loss[0][0] += xx;
        loss[1][0] += xy;
        loss[1][1] += yy;
        for (int i = TURN; i < COUNT; i++) {
            rise[i] += riseX * ux[i] + riseY * uy[i];
            double lossX = xx * ux[i] + xy * uy[i];
            double lossY = xy * ux[i] + yy * uy[i];
            double[] row = loss[i];
            row[0] += lossX;
            row[1] += lossY;
            for (int j = TURN; j <= i; j++) {
                row[j] += lossX * ux[j] + lossY * uy[j];
            }
        }
    }

    private void flowAt(double x, double y) {
        ux[TURN] = -y;
        uy[TURN] = x;
        ux[GROW] = x;
        uy[GROW] = y;
        ux[STRETCH] = x;
        uy[STRETCH] = -y;
        ux[SHEAR] = y;
        uy[SHEAR] = x;
        ux[PERSPECTIVE_X] = x * x;
        uy[PERSPECTIVE_X] = x * y;
        ux[PERSPECTIVE_Y] = x * y;
        uy[PERSPECTIVE_Y] = y * y;
    }

    /** Multiplies all rises and losses. */
    void multiply(double by) {
        for (int i = 0; i < COUNT; i++) {
            rise[i] *= by;
            for (int j = 0; j <= i; j++) {
                loss[i][j] *= by;
            }
        }
    }

    /** Radius of the structure in px. */
    double radius() {
        return radius;
    }

    /** Rise of the metric per px/s of a parameter. */
    double rise(int parameter) {
        return rise[parameter];
    }

    /** Loss per (px/s)² of two parameters, an entry of a symmetric matrix. */
    double loss(int i, int j) {
        return loss[Math.max(i, j)][Math.min(i, j)];
    }
}
