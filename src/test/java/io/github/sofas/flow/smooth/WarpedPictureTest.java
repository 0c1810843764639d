package io.github.sofas.flow.smooth;

import static org.junit.Assert.assertEquals;

import io.github.sofas.event.SensorSize;
import java.util.Random;
import org.junit.Test;

public class WarpedPictureTest {
    /** 1 4 6 4 1 along rows and columns: the sum of the squares of an event's blurred picture. */
    private static final double ALONE = 70 * 70;
    /** The sum of the products of 1 4 6 4 1 with itself moved by one. */
    private static final double BESIDE = 56;
    private static final double EXACT = 1e-9;

    private final WarpedPicture picture = new WarpedPicture(new SensorSize(20, 10));

    @Test
    public void eventMeetsItselfOnceAndTwoOnAPixelMeetFourTimes() {
        picture.add(3, 4);
        assertEquals(ALONE, picture.meetings(), EXACT);
        picture.add(3.4, 3.6);
        assertEquals(4 * ALONE, picture.meetings(), EXACT);
    }

    @Test
    public void eventsSideBySideMeetByAsMuchAsTheirBlursOverlap() {
        picture.add(3, 4);
        picture.add(4, 4);
        assertEquals(2 * ALONE + 2 * BESIDE * 70, picture.meetings(), EXACT);
        picture.clear();
        picture.add(3, 4);
        picture.add(4, 5);
        assertEquals(2 * ALONE + 2 * BESIDE * BESIDE, picture.meetings(), EXACT);
    }

    @Test
    public void eventsMovedOffTheSensorAreSeenUpTo8Px() {
        picture.add(-8, -8);
        picture.add(27, 17);
        assertEquals(2 * ALONE, picture.meetings(), EXACT);
        picture.add(-9, 5);
        picture.add(28, 5);
        picture.add(5, -9);
        picture.add(5, 18);
        assertEquals(2 * ALONE, picture.meetings(), EXACT);
    }

    @Test
    public void pictureIsThatOfTheEventsSinceItWasCleared() {
        Random random = new Random(7);
        for (int k = 0; k < 50; k++) {
            picture.add(random.nextInt(20), random.nextInt(10));
        }
        picture.meetings();
        picture.clear();
        assertEquals(0, picture.meetings(), EXACT);
        picture.add(19, 9);
        assertEquals(ALONE, picture.meetings(), EXACT);
    }

    @Test
    public void meetingsAreThoseOfAPlainBlur() {
        Random random = new Random(11);
        double[][] plain = new double[60][60];
        int[] weights = {1, 4, 6, 4, 1};
        for (int k = 0; k < 300; k++) {
            int x = random.nextInt(20);
            int y = random.nextInt(10);
            picture.add(x, y);
            for (int dy = 0; dy < 5; dy++) {
                for (int dx = 0; dx < 5; dx++) {
                    plain[y + 20 + dy][x + 20 + dx] += weights[dx] * weights[dy];
                }
            }
        }
        double sum = 0;
        for (double[] row : plain) {
            for (double value : row) {
                sum += value * value;
            }
        }
        assertEquals(sum, picture.meetings(), EXACT * sum);
    }
}
