package io.github.sofas.flow.fit;

import static org.junit.Assert.assertEquals;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.Random;
import org.junit.Test;

public class BilinearAccumulatorTest {
    private static final int SUB = 16;
    private static final double CELL_PX = 1.0;

    /** Votes on cells without a border, kept by column and row, event by event as the class says. */
    private static double plain(int[] x, int[] y, int[] sign, int shiftX, int shiftY, int offset) {
        Map<Long, Integer> cells = new HashMap<>();
        long sum = 0;
        for (int i = 0; i < x.length; i++) {
            int px = x[i] * SUB + offset - shiftX;
            int py = y[i] * SUB + offset - shiftY;
            for (int corner = 0; corner < 4; corner++) {
                int column = Math.floorDiv(px, SUB) + corner % 2;
                int row = Math.floorDiv(py, SUB) + corner / 2;
                int weight = sign[i] * (SUB - Math.abs(px - column * SUB)) * (SUB - Math.abs(py - row * SUB));
                int before = cells.getOrDefault((long) row << 32 | column & 0xFFFFFFFFL, 0);
                sum += (long) weight * before;
                cells.put((long) row << 32 | column & 0xFFFFFFFFL, before + weight);
            }
        }
        return sum * 2.0 / (SUB * SUB * SUB * SUB);
    }

    /** Every event is shifted alike, by whole sixteenths, so that the plain votes need no rounding. */
    private static ShiftProfile ones(int n) {
        float[] ones = new float[n];
        Arrays.fill(ones, 1);
        ShiftProfile profile = new ShiftProfile(n);
        profile.take(ones, n);
        return profile;
    }

    @Test
    public void metricIsThatOfPlainVotesAtAnyShiftThatKeepsEventsOnTheGrid() {
        Random random = new Random(5);
        int n = 200;
        int[] x = new int[n];
        int[] y = new int[n];
        int[] sign = new int[n];
        BilinearAccumulator accumulator = new BilinearAccumulator(64, 64, CELL_PX, n, n);
        for (int i = 0; i < n; i++) {
            x[i] = 20 + random.nextInt(12);
            y[i] = 30 + random.nextInt(9);
            sign[i] = random.nextBoolean() ? 1 : -1;
            accumulator.add(x[i], y[i], sign[i]);
        }
        accumulator.lay();
        ShiftProfile alike = ones(n);
        for (int shift : new int[] {0, 1, 7, 8, 15, 16, 17, 100, 250, -1, -8, -16, -100, -250}) {
            double px = shift / (double) SUB;
            double expected = (plain(x, y, sign, shift, -shift, 0) + plain(x, y, sign, shift, -shift, SUB / 2)) / 2;
            assertEquals("shift of " + px + " px", expected, accumulator.metric(alike, px, alike, -px), 0);
        }
    }

    @Test
    public void eventsThatMeetAfterTheirShiftsCountHoweverFarApartTheyWere() {
        // 12 px apart, each shifted by 6 towards the other; two whole votes on one cell give 2 w f = 2
        BilinearAccumulator accumulator = new BilinearAccumulator(64, 64, CELL_PX, 2, 0);
        accumulator.add(20, 30, 1);
        accumulator.add(32, 30, 1);
        accumulator.lay();
        ShiftProfile apart = new ShiftProfile(2);
        apart.take(new float[] {-1, 1}, 2);
        ShiftProfile still = new ShiftProfile(2);
        still.take(new float[] {0, 0}, 2);
        assertEquals(2, accumulator.metric(apart, 6, still, 0), 0);
        assertEquals(0, accumulator.metric(apart, 5, still, 0), 0);
    }

    private static void addOften(BilinearAccumulator accumulator, int x, int y, int polarity) {
        for (int seen = 0; seen < 8; seen++) {
            accumulator.add(x, y, polarity);
        }
    }

    /** How a frame of events about (32, 32) changes when it turns about a place beside it, or there. */
    private static StructureTensor structureOfFrame(int reachX, int reachY, double turnAboutX) {
        BilinearAccumulator accumulator = new BilinearAccumulator(64, 64, CELL_PX, 4096, 0);
        for (int k = -reachX; k <= reachX; k++) {
            addOften(accumulator, 32 + k, 32 - reachY, 1);
            addOften(accumulator, 32 + k, 32 + reachY, -1);
        }
        for (int k = -reachY; k <= reachY; k++) {
            addOften(accumulator, 32 - reachX, 32 + k, 1);
            addOften(accumulator, 32 + reachX, 32 + k, -1);
        }
        accumulator.lay();
        StructureTensor tensor = new StructureTensor();
        accumulator.structure(tensor, turnAboutX, 32, Math.max(reachX, reachY));
        return tensor;
    }

    @Test
    public void squareShowsItsTurningAndItsGrowth() {
        StructureTensor tensor = structureOfFrame(12, 12, 32);
        assertEquals(1, tensor.own(StructureTensor.TURN), 0.1);
        assertEquals(1, tensor.own(StructureTensor.GROW), 0.1);
    }

    @Test
    public void turningAboutAFarPlaceIsMostlyAShift() {
        // about 48 px to the left each place moves down by 48 px a rad, give or take 12: a shift explains all but
        // 4 % of it, and of the shift itself a sixth may be noise, 0.005 of 0.03
        StructureTensor tensor = structureOfFrame(12, 12, -16);
        assertEquals(0.04 + 0.17, tensor.own(StructureTensor.TURN), 0.05);
    }
}
