package io.github.sofas.flow.fit;

/**
 * What a measurement knows of a structure's motion: the metric along the motion, and how much of the metric another
 * motion would lose, to second order. A corner loses by any other velocity, a straight edge only by a velocity across
 * it, and a disc loses nothing by rotation.
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

    /** Forgets all that is known. */
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
     * {@return how well a parameter is known, in px: the standard deviation of the metric, divided by what the metric
     * loses where the parameter shifts the ends of the window by one pixel} Soft pictures lose less than sharp ones.
     *
     * @param itsLoss loss by the parameter, an entry of the matrix or the loss by rotation
     * @param perUnit px that a unit of the parameter shifts the ends of the window by
     */
    double noisePx(double itsLoss, double perUnit) {
        return MetricFit.sd(metric) * perUnit * perUnit / Math.max(itsLoss, Double.MIN_NORMAL);
    }

    /** Knowledge across the best known direction, as a share of that along it: 0 for a straight edge. */
    double flatness() {
        double most = (xx + yy) / 2 + VelocityTop.unevenness(xx, xy, yy);
        return least() / Math.max(most, Double.MIN_NORMAL);
    }

    /** Loss by a motion whose velocity, rotation and growth differ by these amounts. */
    double of(double dvx, double dvy, double dOmega, double dGrowth) {
        return xx * dvx * dvx + 2 * xy * dvx * dvy + yy * dvy * dvy + turn * dOmega * dOmega
            + grow * dGrowth * dGrowth;
    }
}
