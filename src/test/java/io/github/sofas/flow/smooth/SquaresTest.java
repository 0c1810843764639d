package io.github.sofas.flow.smooth;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import org.junit.Test;

public class SquaresTest {
    private static int taken(long us, long share) {
        int taken = 0;
        for (int row = 0; row < 100; row++) {
            for (int column = 0; column < 100; column++) {
                taken += Squares.isTaken(8 * column - 400, 8 * row - 400, us, share) ? 1 : 0;
            }
        }
        return taken;
    }

    @Test
    public void asManyAreWantedAsThereAreTakesAll() {
        assertEquals(10_000, taken(1, Squares.share(4000, 4000)));
        assertEquals(10_000, taken(1, Squares.share(0, 4000)));
    }

    @Test
    public void aboutTheShareThatIsWantedIsTaken() {
        // a quarter of 10,000, and three standard deviations of 43
        assertEquals(2500, taken(1, Squares.share(16_000, 4000)), 130);
        assertEquals(2500, taken(2, Squares.share(16_000, 4000)), 130);
    }

    @Test
    public void aSquareIsTakenWholeOrNotAtAll() {
        long share = Squares.share(2, 1);
        for (double x = -8; x < 0; x += 0.5) {
            for (double y = 16; y < 24; y += 0.5) {
                assertEquals(Squares.isTaken(-8, 16, 7, share), Squares.isTaken(x, y, 7, share));
            }
        }
    }

    @Test
    public void atAnotherTimeOthersAreTaken() {
        long share = Squares.share(2, 1);
        int same = 0;
        for (int column = 0; column < 100; column++) {
            same += Squares.isTaken(8 * column, 0, 1, share) == Squares.isTaken(8 * column, 0, 2, share) ? 1 : 0;
        }
        assertTrue(same + " of 100", same > 25 && same < 75);
    }
}
