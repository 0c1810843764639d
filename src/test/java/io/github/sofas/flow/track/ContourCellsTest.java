package io.github.sofas.flow.track;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.motion.Motion;
import org.junit.Test;

/** Cells at their limits; what they mean for a contour is in {@link ContourTest}. */
public class ContourCellsTest {
    /** With 24 cells around it: 58 columns, 54 rows. */
    private static final SensorSize SENSOR = new SensorSize(10, 6);

    private final ContourCells cells = new ContourCells(SENSOR);

    private int support(double x, double y, int polarity) {
        return cells.support(ContourCells.cell(x), ContourCells.cell(y), polarity);
    }

    @Test
    public void placeLiesOnTheNearestCell() {
        assertEquals(24, ContourCells.cell(-0.5));
        assertEquals(24, ContourCells.cell(0.49));
        assertEquals(25, ContourCells.cell(0.5));
        assertTrue(ContourCells.cell(-26) < 0);
    }

    @Test
    public void placesAtTheBorderOfTheGridHoldNothing() {
        double[][] places = {{-24, 3}, {33, 3}, {5, -24}, {5, 29}, {-1e9, 3}, {5, 1e9}};
        for (double[] place : places) {
            cells.see(place[0], place[1], 1, 0);
            assertTrue(place[0] + ", " + place[1], cells.isEmpty());
        }
        cells.see(-23, -23, 1, 0);
        cells.see(32, 28, 1, 0);
        assertEquals(2, support(-23, -23, 1));
        assertEquals(2, support(32, 28, 1));
        assertEquals(1, cells.minX());
        assertEquals(56, cells.maxX());
        assertEquals(1, cells.minY());
        assertEquals(52, cells.maxY());
    }

    @Test
    public void supportOfEitherPolarityIsThatOfTheOneThatWasSeenMore() {
        cells.see(5, 3, 1, 0);
        cells.see(5, 3, -1, 1);
        cells.see(5, 3, -1, 2);
        assertEquals(2 - 2, support(5, 3, 1));
        assertEquals(2 * 2 - 1, support(5, 3, ContourCells.EITHER));
        assertEquals(2 * 2 - 1, closeSupport(5, 3, ContourCells.EITHER));
    }

    @Test
    public void closeSupportIsThatOfTheFourCellsNearest() {
        cells.see(5, 3, 1, 0);
        cells.see(5, 3, 1, 4);
        cells.see(4, 3, -1, 2);
        // columns 5 and 6, rows 3 and 4; then columns 4 and 5, where the one OFF sixteenth counts by half
        assertEquals(2 * 2, closeSupport(5.4, 3.4, 1));
        assertEquals(2 * 2 - 1, closeSupport(4.6, 2.6, 1));
        assertEquals(2 - 2, closeSupport(4.4, 3, -1));
        // columns 6 and 7: the nine cells around 6 have column 5
        assertEquals(0, closeSupport(6.2, 3, 1));
        assertEquals(2 * 2, support(6.2, 3, 1));
    }

    private int closeSupport(double x, double y, int polarity) {
        return cells.closeSupport(ContourCells.firstOfTwo(x), ContourCells.firstOfTwo(y), polarity);
    }

    @Test
    public void supportIsAtMostThatOfAllSixteenths() {
        for (int age = 0; age < 20; age++) {
            cells.see(5, 3, -1, age);
            cells.see(6, 3, -1, age);
        }
        assertEquals(2 * 16, support(5, 3, -1));
        assertEquals(-16, support(5, 3, 1));
        ContourCells others = new ContourCells(SENSOR);
        others.see(5, 3, -1, 0);
        cells.absorb(others, anchored(), anchored());
        assertEquals(2 * 16, support(5, 3, -1));
    }

    @Test
    public void othersAreAddedWhereTheirFrameLies() {
        ContourCells others = new ContourCells(SENSOR);
        others.see(5, 3, -1, 0);
        others.see(-23, 3, 1, 0);
        Frame its = anchored();
        Frame own = anchored();
        // what is at 5 in the other frame is at 5 + 2 of the sensor, and at 5 + 2 - 4 in the own
        its.shift(-2, 0);
        own.shift(-4, 1);
        cells.absorb(others, its, own);
        assertEquals(2, support(3, 4, -1));
        assertEquals(0, support(5, 4, -1));
        // at the border of the grid or beyond it is left out
        cells.absorb(others, anchored(), own);
        assertEquals(0, support(-23, 4, 1));
    }

    private static Frame anchored() {
        Frame frame = new Frame();
        frame.anchor(new Motion(), 0);
        return frame;
    }

    @Test
    public void olderThanTheLifetimeIsNothing() {
        cells.see(5, 3, 1, 16);
        assertTrue(cells.isEmpty());
        // the oldest sixteenth passes with the next, the newest with the sixteenth
        cells.see(5, 3, 1, 15);
        cells.see(5, 3, -1, 0);
        assertEquals(2 - 1, support(5, 3, 1));
        cells.pass(1);
        assertEquals(-1, support(5, 3, 1));
        cells.pass(14);
        assertEquals(2, support(5, 3, -1));
        cells.pass(1);
        assertTrue(cells.isEmpty());
    }

    @Test
    public void allPassesAtOnceAfterALongTime() {
        cells.see(5, 3, 1, 0);
        cells.pass(1_000_000);
        assertTrue(cells.isEmpty());
    }

    @Test
    public void whatIsShiftedOutOfTheGridIsLost() {
        cells.see(0, 3, 1, 0);
        cells.see(9, 3, -1, 8);
        ContourCells shifted = new ContourCells(SENSOR);
        // 24 columns to the left: the first lies at the border by then, the second at -15
        shifted.takeShifted(cells, 24, 1);
        assertEquals(2, shifted.support(ContourCells.cell(-15), ContourCells.cell(2), -1));
        assertEquals(8, shifted.minX());
        assertEquals(10, shifted.maxX());
        assertFalse(shifted.isOccupied(0, ContourCells.cell(2)));
    }

    @Test
    public void whatIsTurnedTakesTheNearestCell() {
        // by a quarter about (5, 3): the cell at (8, 3) is at (5, 6) then
        Motion turning = new Motion();
        turning.set(0, 0, 0);
        turning.centreX = 5;
        turning.centreY = 3;
        turning.omega = 0.5;
        Frame frame = new Frame();
        frame.anchor(turning, 3);
        for (long timeUs = 0; timeUs <= 3_141_593; timeUs += 100_000) {
            turning.moveReference(timeUs);
            frame.follow(turning, 3);
        }
        cells.see(8, 3, 1, 0);
        ContourCells turned = new ContourCells(SENSOR);
        turned.takeTurned(cells, frame);
        assertTrue(turned.isOccupied(ContourCells.cell(5), ContourCells.cell(6)));
        assertFalse(turned.isOccupied(ContourCells.cell(8), ContourCells.cell(3)));
    }
}
