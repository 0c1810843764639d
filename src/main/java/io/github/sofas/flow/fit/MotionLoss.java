package io.github.sofas.flow.fit;

/**
 * What a measurement knows of a structure's motion: the metric under it, and how much of that another motion would
 * lose, to second order. A corner loses by any other velocity, a straight edge by one across it only, and a disc loses
 * nothing by turning.
 */
public final class MotionLoss {
    /** In votes squared. */
    public double metric;
    /** Loss per (px/s)², a symmetric matrix. */
    public double xx;
    public double xy;
    public double yy;
    /** Loss per (rad/s)² about the structure's centre. */
    public double turn;
    /** Loss per (1/s)² by another growth about the structure's centre. */
    public double grow;
    /** Direction in which the velocity is known best, a unit vector. */
    public double axisX;
    public double axisY;

    /** Nothing is known. */
    public void clear() {
        metric = 0;
        xx = 0;
        xy = 0;
        yy = 0;
        turn = 0;
        grow = 0;
        axisX = 0;
        axisY = 0;
    }

    /** Takes over what a fit found of the velocity. */
    public void take(VelocityTop top) {
        metric = top.metric();
        xx = top.lossXx();
        xy = top.lossXy();
        yy = top.lossYy();
        axisX = top.axisX();
        axisY = top.axisY();
    }

    /** Loss per (px/s)² along the better known of the sensor's axes. */
    public double best() {
        return Math.max(xx, yy);
    }

    /** Loss per (px/s)² in the direction in which the velocity is known least: 0 along a straight edge. */
    public double least() {
        return (xx + yy) / 2 - VelocityTop.unevenness(xx, xy, yy);
    }

    /**
     * {@return how well a parameter is known, in px: the standard deviation of the metric, over what it loses where the
     * parameter shifts the ends of the window by a pixel, times that pixel} Soft pictures lose less than sharp ones.
     *
     * @param itsLoss loss by the parameter, an entry of the matrix or that of turning
     * @param perUnit px that a unit of the parameter shifts the ends of the window by
     */
    double noisePx(double itsLoss, double perUnit) {
        return MetricFit.sd(metric) * perUnit * perUnit / Math.max(itsLoss, Double.MIN_NORMAL);
    }

    /** What is known across the best direction, as a share of what is known along it: 0 for a straight edge. */
    double flatness() {
        double most = (xx + yy) / 2 + VelocityTop.unevenness(xx, xy, yy);
        return least() / Math.max(most, Double.MIN_NORMAL);
    }

    /** Loss by a velocity, a rotation and a growth that differ by these. */
    double of(double dvx, double dvy, double dOmega, double dGrowth) {
        return xx * dvx * dvx + 2 * xy * dvx * dvy + yy * dvy * dvy + turn * dOmega * dOmega
            + grow * dGrowth * dGrowth;
    }
}
