package io.github.sofas.flow.track;

import static org.junit.Assert.assertTrue;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.flow.Segment;
import io.github.sofas.flow.SofasParameters;
import io.github.sofas.flow.fit.MetricFit;
import java.util.ArrayList;
import java.util.List;
import java.util.function.IntUnaryOperator;

/**
 * A stack of track planes that follow upright edges, which enter a column at a time. At 100 px/s the lifetime of 5 px
 * is 50 ms.
 */
final class TrackedEdges {
    /** Rows of an edge. */
    static final int ROWS = 30;
    /** Columns that it has entered when it is found. */
    static final int COLUMNS = 5;
    private static final SensorSize SENSOR = new SensorSize(128, 96);
    private static final SofasParameters.Track P = SofasParameters.defaults().track();

    final MetricFit fit = newFit();
    final List<Segment> ended = new ArrayList<>();
    final TrackPlaneStack stack = new TrackPlaneStack(SENSOR, P, fit, newFit(), ended::add,
        (segment, motion) -> { });
    final FlowOutput output = new FlowOutput(1);
    long nowUs = 1_000_000;

    private static MetricFit newFit() {
        return new MetricFit(128, 96, MetricFit.CELL_PX, TrackPlaneStack.MOST_MEASURED, 1900);
    }

    /** An edge that has come to a column by now, each pixel of which fired some times as the edge entered it. */
    TrackPlane begin(int column, int row, double vx, int times) {
        return begin(column, row, vx, times, COLUMNS);
    }

    /** The same of one that was seen to enter so many columns. */
    TrackPlane begin(int column, int row, double vx, int times, int columns) {
        return begin(column, row, vx, times, columns, y -> 1);
    }

    /** The same whose pixels of a row fire with a polarity each. */
    TrackPlane begin(int column, int row, double vx, int times, int columns, IntUnaryOperator polarityOfRow) {
        TrackPlane plane = stack.found().create(nowUs, vx, 0);
        for (int c = columns - 1; c >= 0; c--) {
            long timeUs = nowUs - (long) (c * 1e6 / Math.abs(vx));
            for (int i = 0; i < times * ROWS; i++) {
                plane.addPast(column - c * (int) Math.signum(vx), row + i % ROWS, timeUs,
                    polarityOfRow.applyAsInt(i % ROWS), true);
            }
        }
        stack.found().begin(plane, nowUs);
        stack.adopt();
        return plane;
    }

    /**
     * A wall that moves to the right at 100 px/s, and has a dot every 8 px, some rows of them.
     *
     * @param fromRow row above the first, a multiple of 8
     */
    TrackPlane beginWall(int fromRow, int rows) {
        TrackPlane plane = stack.found().create(nowUs, 100, 0);
        for (int c = COLUMNS - 1; c >= 0; c--) {
            for (int y = fromRow + 1; y < fromRow + 8 * rows; y += 8) {
                for (int x = 8; x < SENSOR.width() - 8; x += 8) {
                    plane.addPast(x - c, y, nowUs - c * 10_000, 1, true);
                }
            }
        }
        stack.found().begin(plane, nowUs);
        stack.adopt();
        return plane;
    }

    /** The segment that an ON event of now is given. */
    int label(int x, int y) {
        return label(x, y, 1);
    }

    private int label(int x, int y, int polarity) {
        output.segment[0] = -1;
        if (stack.label(x, y, nowUs, polarity, output, 0)) {
            assertTrue(output.segment[0] > 0);
        }
        return output.segment[0];
    }

    /** An edge goes on for some columns, each of which it enters after 10 ms. */
    int goOn(int column, int row, int columns) {
        int segment = 0;
        for (int c = 1; c <= columns; c++) {
            nowUs += 10_000;
            for (int y = 0; y < ROWS; y++) {
                segment = label(column + c, row + y);
            }
            stack.check(nowUs);
        }
        return segment;
    }

    /** Two edges go on for some columns, each of which they enter after 10 ms; then the planes are looked after. */
    void goOnWithTwo(int column, int row, int otherColumn, int otherRow, int columns) {
        goOnWithTwo(column, row, y -> 1, otherColumn, otherRow, y -> 1, columns);
    }

    /** The same whose pixels of a row fire with a polarity each. */
    void goOnWithTwo(int column, int row, IntUnaryOperator polarityOfRow, int otherColumn, int otherRow,
                     IntUnaryOperator otherPolarityOfRow, int columns) {
        for (int c = 1; c <= columns; c++) {
            nowUs += 10_000;
            for (int y = 0; y < ROWS; y++) {
                label(column + c, row + y, polarityOfRow.applyAsInt(y));
                label(otherColumn + c, otherRow + y, otherPolarityOfRow.applyAsInt(y));
            }
        }
        stack.check(nowUs);
    }

    /** No events come for 200 ms. */
    void pause() {
        for (int i = 0; i < 40; i++) {
            nowUs += 5_000;
            stack.check(nowUs);
        }
    }

    /** Ids of the planes. */
    List<Integer> ids() {
        return stack.segments().stream().map(Segment::id).toList();
    }
}
