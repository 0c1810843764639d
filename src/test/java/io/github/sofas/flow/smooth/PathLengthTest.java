package io.github.sofas.flow.smooth;

import static org.junit.Assert.assertEquals;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.fit.MeetingPicture;
import java.util.Random;
import org.junit.Test;

/**
 * Jagged edges of 20 px that move to the right. Each pixel that an edge comes to fires at that moment, and twice more,
 * up to 1.5 px of way later. The path takes the events back to where the edges were at first, by a multiple of the way.
 */
public class PathLengthTest {
    private static final int MOST = 4000;
    private static final double LATE_PX = 1.5;
    private static final SensorSize SENSOR = new SensorSize(64, 48);

    private final MeetingPicture picture = new MeetingPicture(SENSOR);
    private final PathLength length = new PathLength(SENSOR, MOST, picture);
    private final int[] pixel = new int[MOST];
    private final int[] x = new int[MOST];
    private final int[] y = new int[MOST];
    private final Random random = new Random(1);
    private int events;

    /** An edge that moves so many px from a column on, which it leaves after a way of some px. */
    private void edge(int column, int px, int afterPx, double times) {
        for (int k = 0; k < px; k++) {
            for (int row = 10; row < 30; row++) {
                double way = afterPx + k + 0.37 * row % 1;
                add(column + k, row, times * way);
                add(column + k, row, times * (way + LATE_PX * random.nextDouble()));
                add(column + k, row, times * (way + LATE_PX * random.nextDouble()));
            }
        }
    }

    private void add(int column, int row, double way) {
        pixel[events] = length.pixel(column, row, 1);
        x[events] = MeetingPicture.place(column - way);
        y[events] = MeetingPicture.place(row);
        events++;
    }

    private double factor() {
        return length.factor(pixel, x, y, events);
    }

    @Test
    public void wayThatIsTooShortIsLengthenedToWhereFirstEventsMeet() {
        edge(20, 10, 0, 0.96);
        assertEquals(1 / 0.96, factor(), 0.005);
    }

    @Test
    public void wayThatIsRightStaysAsItIs() {
        edge(20, 10, 0, 1);
        assertEquals(1, factor(), 0.005);
    }

    @Test
    public void wayThatIsTooLongIsNotShortened() {
        edge(20, 10, 0, 1.1);
        assertEquals(1, factor(), 0);
    }

    @Test
    public void wayIsLengthenedByNoMoreThanLateEventsShortenIt() {
        edge(20, 10, 0, 0.8);
        // the ways are spread evenly over 0 to 8 px: a variance of 64 / 12 px²
        assertEquals(1 + 0.5 / (64.0 / 12), factor(), 0.001);
    }

    @Test
    public void wayOfAFewPixelsStaysAsItIs() {
        // 0 to 4.5 px: a variance of 1.7 px²
        edge(20, 5, 0, 0.9);
        assertEquals(1, factor(), 0);
    }

    @Test
    public void edgeThatComesToTheSamePixelsAfterAnotherCounts() {
        // the first edge shows nothing: it goes 1 px; the second goes 10 px over the same pixels, 4 px of way later
        edge(20, 1, 0, 0.96);
        edge(20, 10, 4, 0.96);
        assertEquals(1 / 0.96, factor(), 0.005);
    }

    @Test
    public void eventsOfTheCallBeforeAreForgotten() {
        edge(20, 10, 0, 0.96);
        double first = factor();
        assertEquals(first, factor(), 0);
    }
}
