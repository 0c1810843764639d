package io.github.sofas.flow.smooth;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.util.Random;
import org.junit.Test;

public class PartShiftsTest {
    private static final int PARTS = 7;

    private final PartShifts shifts = new PartShifts(PARTS);

    /** Pulls at a part towards a place, by a parabola that is curved alike all round. */
    private void pullTo(int part, double x, double y, double curvature) {
        shifts.pull(part, curvature * (x - shifts.x(part)), curvature * (y - shifts.y(part)), curvature, 0, curvature);
    }

    @Test
    public void whatNothingPullsAtStaysWhereItIs() {
        shifts.clear();
        assertFalse(shifts.step());
        assertEquals(0, shifts.x(3), 0);
        assertEquals(0, shifts.gain(), 0);
    }

    @Test
    public void partsThatArePulledAlikeGoThere() {
        shifts.clear();
        for (int part = 0; part < PARTS; part++) {
            pullTo(part, 0.5, -0.25, 8);
        }
        assertTrue(shifts.step());
        for (int part = 0; part < PARTS; part++) {
            // but for the thousandth that a shift costs; an axis that is as flat as the best one counts 0.8
            assertEquals(0.5, shifts.x(part), 0.002);
            assertEquals(-0.25, shifts.y(part), 0.002);
        }
    }

    @Test
    public void partWithoutEventsGoesWithItsNeighbours() {
        shifts.clear();
        for (int part = 0; part < PARTS; part++) {
            if (part != 3) {
                pullTo(part, 1, 0, 8);
            }
        }
        shifts.step();
        assertEquals(1, shifts.x(3), 0.01);
    }

    @Test
    public void partsAlongAStraightEdgeAreShiftedAcrossItOnly() {
        shifts.clear();
        for (int part = 0; part < PARTS; part++) {
            // upright: curved along x, all but flat along y, where something pulls by a hundredth
            shifts.pull(part, 4, 0.04 * (part % 2 * 2 - 1), 8, 0, 0.08);
        }
        shifts.step();
        for (int part = 0; part < PARTS; part++) {
            assertEquals(0.5, shifts.x(part), 0.002);
            assertEquals(0, shifts.y(part), 0.001);
        }
    }

    @Test
    public void nothingPullsByMoreThanAPixel() {
        shifts.clear();
        for (int part = 0; part < PARTS; part++) {
            pullTo(part, 5, 0, 8);
        }
        shifts.step();
        assertEquals(1, shifts.x(0), 0.002);
    }

    @Test
    public void shiftsBalanceWhatPullsAndWhatChangesCost() {
        // the plain way: the sum is least where no shift that differs a little makes it less
        Random random = new Random(1);
        double[] toX = new double[PARTS];
        double[] toY = new double[PARTS];
        shifts.clear();
        for (int part = 0; part < PARTS; part++) {
            toX[part] = random.nextDouble() - 0.5;
            toY[part] = random.nextDouble() - 0.5;
            pullTo(part, toX[part], toY[part], 8);
        }
        shifts.step();
        double[] x = new double[PARTS];
        double[] y = new double[PARTS];
        for (int part = 0; part < PARTS; part++) {
            x[part] = shifts.x(part);
            y[part] = shifts.y(part);
        }
        double least = cost(x, toX, 1) + cost(y, toY, 0.8);
        for (int part = 0; part < PARTS; part++) {
            for (double off : new double[] {-0.01, 0.01}) {
                x[part] += off;
                assertTrue(cost(x, toX, 1) + cost(y, toY, 0.8) > least);
                x[part] -= off;
                y[part] += off;
                assertTrue(cost(x, toX, 1) + cost(y, toY, 0.8) > least);
                y[part] -= off;
            }
        }
    }

    /** Of pulls that are curved by 8 along one axis and by 0.8 of it along the other: 7.2 in the mean. */
    private static double cost(double[] at, double[] to, double counts) {
        double mean = 7.2;
        double sum = 0;
        for (int part = 0; part < PARTS; part++) {
            sum += 8 * counts * (at[part] - to[part]) * (at[part] - to[part]) + 1e-3 * mean * at[part] * at[part];
            if (part >= 1) {
                sum += mean * Math.pow(at[part] - at[part - 1], 2);
            }
            if (part >= 2) {
                sum += 0.5 * mean * Math.pow(at[part] - 2 * at[part - 1] + at[part - 2], 2);
            }
        }
        return sum;
    }
}
