package io.github.sofas.simulate;

/**
 * The path of a pendulum's bob, which is rigid with its rod and swings about a pivot without loss.
 *
 * <p>The motion is that of the full equation, theta'' = -(g / L) sin theta, not of its small-angle sinusoid. With
 * k = sin(thetaMax / 2) and w = sqrt(g / L) its solution from rest at -thetaMax is sin(theta / 2) = k sn(w t - K) and
 * theta' = 2 k w cn(w t - K), where sn and cn are Jacobi's elliptic functions of modulus k and K is their quarter
 * period. The greatest speed, 2 k w L, is the paper's sqrt(2 g L (1 - cos thetaMax)); the period, 4 K / w, is 1.0 %
 * longer than the paper's 2 pi sqrt(L / g) at 23 degrees. The elliptic functions are computed by the
 * arithmetic-geometric mean (Abramowitz and Stegun, 16.4 and 17.6).
 */
final class Pendulum implements Trajectory {
    /** The paper's length, greatest angle and gravity. */
    static final double LENGTH_M = 0.72;
    static final double MAX_ANGLE_RAD = Math.toRadians(23);
    static final double GRAVITY_M_PER_S2 = 9.82;

    private static final int AGM_STEPS = 6;

    private final double pivotX;
    private final double pivotY;
    private final double lengthPx;
    private final double turnedRad;
    private final double cosTurned;
    private final double sinTurned;
    private final double k = StrictMath.sin(MAX_ANGLE_RAD / 2);
    private final double w = Math.sqrt(GRAVITY_M_PER_S2 / LENGTH_M);
    private final double[] a = new double[AGM_STEPS + 1];
    private final double[] c = new double[AGM_STEPS + 1];

    /**
     * Makes a pendulum.
     *
     * @param lowestX column of the bob's centre at the lowest point of its swing
     * @param turnedRad angle by which the whole picture is turned; at 0 gravity points down
     */
    Pendulum(double lowestX, double lowestY, double pxPerM, double turnedRad) {
        lengthPx = LENGTH_M * pxPerM;
        this.turnedRad = turnedRad;
        cosTurned = StrictMath.cos(turnedRad);
        sinTurned = StrictMath.sin(turnedRad);
        pivotX = lowestX + lengthPx * sinTurned;
        pivotY = lowestY - lengthPx * cosTurned;
        a[0] = 1;
        c[0] = k;
        double b = Math.sqrt(1 - k * k);
        for (int n = 1; n <= AGM_STEPS; n++) {
            a[n] = (a[n - 1] + b) / 2;
            c[n] = (a[n - 1] - b) / 2;
            b = Math.sqrt(a[n - 1] * b);
        }
    }

    /** Greatest speed of the bob's centre with the paper's constants, in m/s. */
    static double peakSpeedMPerS() {
        return Math.sqrt(2 * GRAVITY_M_PER_S2 * LENGTH_M * (1 - StrictMath.cos(MAX_ANGLE_RAD)));
    }

    /** Period of a whole swing, there and back, in s. */
    double periodS() {
        return 4 * quarterPeriod() / w;
    }

    private double quarterPeriod() {
        return Math.PI / (2 * a[AGM_STEPS]);
    }

    @Override
    public void poseAt(double timeS, Pose pose) {
        double phi = (1 << AGM_STEPS) * a[AGM_STEPS] * (w * timeS - quarterPeriod());
        for (int n = AGM_STEPS; n > 0; n--) {
            phi = (phi + StrictMath.asin(c[n] / a[n] * StrictMath.sin(phi))) / 2;
        }
        double theta = 2 * StrictMath.asin(k * StrictMath.sin(phi));
        double thetaPerS = 2 * k * w * StrictMath.cos(phi);
        // With gravity downwards the bob hangs at (sin theta, cos theta) from its pivot; the rod turns against theta.
        double hangX = lengthPx * StrictMath.sin(theta);
        double hangY = lengthPx * StrictMath.cos(theta);
        double armX = cosTurned * hangX - sinTurned * hangY;
        double armY = sinTurned * hangX + cosTurned * hangY;
        pose.x = pivotX + armX;
        pose.y = pivotY + armY;
        pose.turnTo(turnedRad - theta);
        pose.turnRadPerS = -thetaPerS;
        pose.keepSize();
        pose.vxPxPerS = thetaPerS * armY;
        pose.vyPxPerS = -thetaPerS * armX;
    }

    @Override
    public double maxSpeedPxPerS(double distancePx) {
        return 2 * k * w * (lengthPx + distancePx);
    }
}
