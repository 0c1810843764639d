package io.github.sofas.flow.search;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.SofasParameters;
import java.util.Random;
import org.junit.Test;

public class HeldCellsTest {
    private static final SensorSize SENSOR = new SensorSize(346, 260);

    private static boolean has(HeldCells held, int column, int row) {
        return held.hasRow(row) && (column < held.untilColumn()
            || column >= held.fromColumn() && column < held.endColumn());
    }

    private static int count(HeldCells held, int columns, int rows) {
        int count = 0;
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                count += has(held, column, row) ? 1 : 0;
            }
        }
        return count;
    }

    @Test
    public void cellsGoOnAtTheOtherSide() {
        HeldCells held = new HeldCells(8, 4);
        held.set(6, 3, 3, 2);
        // columns 6, 7 and 0 of the rows 3 and 0
        assertTrue(has(held, 6, 3));
        assertTrue(has(held, 0, 3));
        assertTrue(has(held, 7, 0));
        assertFalse(has(held, 1, 3));
        assertFalse(has(held, 5, 0));
        assertFalse(has(held, 6, 1));
        assertEquals(6, count(held, 8, 4));
    }

    @Test
    public void moreThanThereAreAreAll() {
        HeldCells held = new HeldCells(8, 4);
        held.set(5, 9, 3, 7);
        assertEquals(32, count(held, 8, 4));
    }

    @Test
    public void noCellsAreHeldWhereThereAreNone() {
        HeldCells held = new HeldCells(8, 4);
        held.set(0, 0, 0, 0);
        assertEquals(0, count(held, 8, 4));
    }

    @Test
    public void eventsOfAnyProjectionFallOnThem() {
        Projections projections = new Projections(SENSOR.width(), SENSOR.height(), SofasParameters.defaults().search());
        int columns = 1 << projections.columnBits();
        int rows = 1 << projections.rowBits();
        HeldCells held = new HeldCells(columns, rows);
        Random random = new Random(1);
        int[][] corners = {{0, 0}, {345, 0}, {0, 259}, {345, 259}};
        for (int k = 0; k < projections.n() * projections.n(); k++) {
            for (int round = 0; round < 20; round++) {
                long fromUs = (long) (1e9 * random.nextDouble());
                long untilUs = fromUs + (long) (projections.windowUs(k / projections.n()) * random.nextDouble());
                projections.findHeld(k, fromUs, untilUs, SENSOR, held);
                for (int[] corner : corners) {
                    for (long us : new long[] {fromUs, untilUs, fromUs + (untilUs - fromUs) / 3}) {
                        int cell = projections.cell(k, corner[0], corner[1], us);
                        assertTrue(k + " at " + us, has(held, cell & columns - 1, cell >> projections.columnBits()));
                    }
                }
                // the sensor in cells of 2 px, the travel, and a cell begun on either side
                int travel = (int) Projections.TRAVEL_PX / 2;
                assertTrue(count(held, columns, rows) <= (173 + travel + 2) * (130 + travel + 2));
            }
        }
    }
}
