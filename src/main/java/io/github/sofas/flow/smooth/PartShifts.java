package io.github.sofas.flow.smooth;

import io.github.sofas.flow.fit.LinearSystem;
import io.github.sofas.flow.fit.MetricFit;
import java.util.Arrays;

/**
 * Finds how far, in px, to shift each of several successive parts of the time. The pulls on the parts are balanced
 * against two costs: that the shifts change from part to part, and that their change changes. A part without a pull
 * follows its neighbours. A direction that hardly any part shows is left as it is.
 */
final class PartShifts {
    /**
     * Cost of a change of the shifts by 1 px from one part to the next, as a multiple of the mean curvature of the
     * pulls.
     */
    private static final double CHANGE_COST = 1;
    /** The same for a change of that change. */
    private static final double BEND_COST = 0.5;
    /** The same for a shift itself: shifts that are the same for all parts change nothing. */
    private static final double SHIFT_COST = 1e-3;
    /** Curvature across the axis of greatest curvature, as a share of the greatest, at which it counts half. */
    private static final double FLAT = 0.5;
    private static final int[] CHANGE = {1, -1};
    private static final int[] BEND = {1, -2, 1};

    private final int parts;
    private final double[] shifts;
    /** Its unknowns are x and y of each part, part by part. */
    private final LinearSystem balance;
    private final double[] right;
    private double curvatures;
    private double gain;

    PartShifts(int parts) {
        this.parts = parts;
        shifts = new double[2 * parts];
        right = new double[2 * parts];
        balance = new LinearSystem(2 * parts);
    }

    /** Begins without shifts. */
    void clear() {
        Arrays.fill(shifts, 0);
        begin();
    }

    private void begin() {
        balance.clear();
        Arrays.fill(right, 0);
        curvatures = 0;
    }

    /** Shift of a part to the right. */
    double x(int part) {
        return shifts[2 * part];
    }

    /** Shift of a part downwards. */
    double y(int part) {
        return shifts[2 * part + 1];
    }

    /**
     * Adds a pull on a part at its present place: a parabola with these slopes and with this downward curvature. Where
     * the curvature is too small or not downward, the slope pulls by one pixel, because nothing was seen farther off.
     */
    void pull(int part, double slopeX, double slopeY, double xx, double xy, double yy) {
        double middle = (xx + yy) / 2;
        double off = Math.sqrt((xx - yy) * (xx - yy) / 4 + xy * xy);
        double angle = 0.5 * StrictMath.atan2(2 * xy, xx - yy);
        double c = StrictMath.cos(angle);
        double s = StrictMath.sin(angle);
        double slopeAlong = slopeX * c + slopeY * s;
        double slopeAcross = slopeY * c - slopeX * s;
        double along = atLeast(middle + off, slopeAlong);
        double across = atLeast(middle - off, slopeAcross);
        double shown = MetricFit.shown(across, FLAT * along);
        slopeAcross *= shown;
        across *= shown;
        int i = 2 * part;
        balance.add(i, i, along * c * c + across * s * s);
        balance.add(i + 1, i, (along - across) * c * s);
        balance.add(i + 1, i + 1, along * s * s + across * c * c);
        right[i] += slopeAlong * c - slopeAcross * s;
        right[i + 1] += slopeAlong * s + slopeAcross * c;
        curvatures += (along + across) / 2;
    }

    private static double atLeast(double curvature, double slope) {
        return Math.max(curvature, Math.abs(slope));
    }

    /** Shifts the parts further by the pulls, and forgets the pulls; false if nothing pulls. */
    boolean step() {
        boolean isPulled = curvatures > 0;
        gain = 0;
        if (isPulled) {
            double mean = curvatures / parts;
            for (int i = 0; i < 2 * parts; i++) {
                balance.add(i, i, SHIFT_COST * mean);
                if (i >= 2) {
                    charge(i, CHANGE, CHANGE_COST * mean);
                }
                if (i >= 4) {
                    charge(i, BEND, BEND_COST * mean);
                }
            }
            double[] slopes = right.clone();
            // positive definite, because each shift has its cost
            balance.factor();
            balance.solve(right);
            for (int i = 0; i < 2 * parts; i++) {
                gain += slopes[i] * right[i] / 2;
                shifts[i] += right[i];
            }
        }
        begin();
        return isPulled;
    }

    /** Expected gain of the last step, as far as the pulls are parabolas. */
    double gain() {
        return gain;
    }

    /**
     * Adds the cost of the square of a difference: of a shift and those one and two parts before, each times its
     * factor.
     */
    private void charge(int last, int[] times, double cost) {
        double difference = 0;
        for (int k = 0; k < times.length; k++) {
            difference += times[k] * shifts[last - 2 * k];
        }
        for (int k = 0; k < times.length; k++) {
            right[last - 2 * k] -= cost * times[k] * difference;
            for (int l = k; l < times.length; l++) {
                balance.add(last - 2 * k, last - 2 * l, cost * times[k] * times[l]);
            }
        }
    }
}
