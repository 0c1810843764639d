package io.github.sofas.simulate;

import java.util.Random;

/**
 * A smooth random path like that of a creature in a box. The creature moves along its heading or backwards, speeds up
 * and slows down, turns, sometimes reverses, and steers back before it leaves the box.
 *
 * <p>Speed and rate of turning follow random targets through two low-pass filters. Their integral is stored every 5 ms.
 * Between these knots, place and angle are cubic, and the velocity is their exact derivative, so that truth and picture
 * agree.
 */
final class Wander implements Trajectory {
    private static final double KNOT_S = 0.005;
    private static final int STEPS_PER_KNOT = 5;
    private static final double STEP_S = KNOT_S / STEPS_PER_KNOT;
    private static final double SPEED_LAG_S = 0.12;
    private static final double TURN_LAG_S = 0.15;
    private static final double LOOK_AHEAD_S = 0.6;
    private static final double MAX_TURN_RAD_PER_S = 2.5;
    private static final double FREE_TURN_RAD_PER_S = 1.5;
    private static final double REVERSAL_SHARE = 0.3;

    private final int knots;
    /** Per knot: x, y, angle, and the rates of the three per second. */
    private final double[] table;
    private double fastestPxPerS;
    private double fastestRadPerS;

    /**
     * Makes a path.
     *
     * @param centreX column of the centre of the box in or near which the origin stays
     * @param halfWidth half the width of the box
     * @param speedPxPerS typical speed; targets lie between 0.5 and 1.5 times that speed
     * @param durationS duration of the path
     */
    Wander(double startX, double startY, double headingRad, double centreX, double centreY, double halfWidth,
           double halfHeight, double speedPxPerS, double durationS, Random random) {
        knots = (int) Math.ceil(durationS / KNOT_S) + 2;
        table = new double[6 * knots];
        double x = startX;
        double y = startY;
        double angle = headingRad;
        double targetSpeed = speedPxPerS;
        double laggedSpeed = speedPxPerS;
        double speed = speedPxPerS;
        double freeTurn = 0;
        double laggedTurn = 0;
        double turn = 0;
        double nextSpeedS = 0.5 + random.nextDouble();
        double nextTurnS = 0.3;
        for (int step = 0; step < knots * STEPS_PER_KNOT; step++) {
            double cos = StrictMath.cos(angle);
            double sin = StrictMath.sin(angle);
            if (step % STEPS_PER_KNOT == 0) {
                keep(step / STEPS_PER_KNOT, x, y, angle, speed * cos, speed * sin, turn);
            }
            double now = step * STEP_S;
            if (now >= nextSpeedS) {
                double size = speedPxPerS * (0.5 + random.nextDouble());
                boolean reverses = random.nextDouble() < REVERSAL_SHARE;
                targetSpeed = (targetSpeed > 0) == reverses ? -size : size;
                nextSpeedS = now + 0.6 + 0.9 * random.nextDouble();
            }
            if (now >= nextTurnS) {
                freeTurn = FREE_TURN_RAD_PER_S * (2 * random.nextDouble() - 1);
                nextTurnS = now + 0.3 + 0.5 * random.nextDouble();
            }
            double aheadX = x + LOOK_AHEAD_S * targetSpeed * cos - centreX;
            double aheadY = y + LOOK_AHEAD_S * targetSpeed * sin - centreY;
            double wantedTurn = freeTurn;
            if (Math.abs(aheadX) > halfWidth || Math.abs(aheadY) > halfHeight) {
                double forward = targetSpeed > 0 ? 1 : -1;
                double homeX = centreX - x;
                double homeY = centreY - y;
                double astray = StrictMath.atan2((cos * homeY - sin * homeX) * forward,
                        (cos * homeX + sin * homeY) * forward);
                wantedTurn = Math.max(-MAX_TURN_RAD_PER_S, Math.min(MAX_TURN_RAD_PER_S, 3 * astray));
                if (Math.abs(astray) > Math.PI * 2 / 3) {
                    // The middle of the box is behind: reversing is quicker than turning.
                    targetSpeed = -targetSpeed;
                    nextSpeedS = now + 0.6 + 0.9 * random.nextDouble();
                }
            }
            laggedSpeed += STEP_S / SPEED_LAG_S * (targetSpeed - laggedSpeed);
            speed += STEP_S / SPEED_LAG_S * (laggedSpeed - speed);
            laggedTurn += STEP_S / TURN_LAG_S * (wantedTurn - laggedTurn);
            turn += STEP_S / TURN_LAG_S * (laggedTurn - turn);
            x += STEP_S * speed * cos;
            y += STEP_S * speed * sin;
            angle += STEP_S * turn;
        }
    }

    private void keep(int knot, double x, double y, double angle, double vx, double vy, double turn) {
        double[] values = {x, y, angle, vx, vy, turn};
        System.arraycopy(values, 0, table, 6 * knot, 6);
        fastestPxPerS = Math.max(fastestPxPerS, Math.sqrt(vx * vx + vy * vy));
        fastestRadPerS = Math.max(fastestRadPerS, Math.abs(turn));
    }

    @Override
    public void poseAt(double timeS, Pose pose) {
        int knot = Math.max(0, Math.min(knots - 2, (int) (timeS / KNOT_S)));
        double u = timeS / KNOT_S - knot;
        pose.x = place(knot, 0, u);
        pose.y = place(knot, 1, u);
        pose.turnTo(place(knot, 2, u));
        pose.vxPxPerS = rate(knot, 0, u);
        pose.vyPxPerS = rate(knot, 1, u);
        pose.turnRadPerS = rate(knot, 2, u);
        pose.keepSize();
    }

    /** Hermite's cubic through the values and rates of two knots, u from 0 to 1. */
    private double place(int knot, int what, double u) {
        int i = 6 * knot + what;
        double rise = table[i + 6] - table[i];
        double in = table[i + 3] * KNOT_S;
        double out = table[i + 9] * KNOT_S;
        return table[i] + u * (in + u * (3 * rise - 2 * in - out + u * (in + out - 2 * rise)));
    }

    private double rate(int knot, int what, double u) {
        int i = 6 * knot + what;
        double rise = table[i + 6] - table[i];
        double in = table[i + 3] * KNOT_S;
        double out = table[i + 9] * KNOT_S;
        return (in + u * (2 * (3 * rise - 2 * in - out) + 3 * u * (in + out - 2 * rise))) / KNOT_S;
    }

    @Override
    public double maxSpeedPxPerS(double distancePx) {
        return 1.05 * (fastestPxPerS + fastestRadPerS * distancePx);
    }
}
