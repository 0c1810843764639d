package io.github.sofas.flow.fit;

import static org.junit.Assert.assertEquals;

import java.util.Arrays;
import java.util.Random;
import org.junit.Test;

public class DenseVotesTest {
    private static final int SUB = BilinearAccumulator.SUB;
    private static final int COLUMNS = 9;
    private static final int ROWS = 7;

    /** Votes one after the other, each with what the cell held before it. */
    private static long plain(int[] x, int[] y, byte[] vote) {
        long[] cells = new long[COLUMNS * ROWS];
        long sum = 0;
        for (int i = 0; i < x.length; i++) {
            boolean isInside = x[i] >= 0 && y[i] >= 0 && x[i] < (COLUMNS - 1) * SUB && y[i] < (ROWS - 1) * SUB;
            for (int corner = 0; isInside && corner < 4; corner++) {
                int column = x[i] / SUB + corner % 2;
                int row = y[i] / SUB + corner / 2;
                long w = vote[i] * (SUB - Math.abs(x[i] - column * SUB)) * (SUB - Math.abs(y[i] - row * SUB));
                sum += w * cells[row * COLUMNS + column];
                cells[row * COLUMNS + column] += w;
            }
        }
        return sum;
    }

    private static long dense(DenseVotes votes, int[] x, int[] y, byte[] vote) {
        int[] at = new int[x.length];
        for (int i = 0; i < x.length; i++) {
            boolean isInside = x[i] >= 0 && y[i] >= 0 && x[i] < (COLUMNS - 1) * SUB && y[i] < (ROWS - 1) * SUB;
            int cell = y[i] / SUB * COLUMNS + x[i] / SUB;
            int place = y[i] % SUB * SUB + x[i] % SUB;
            at[i] = isInside
                ? cell << BilinearAccumulator.KEY_BITS | (vote[i] > 0 ? 0 : BilinearAccumulator.OFF) | place
                : BilinearAccumulator.NONE;
        }
        return votes.vote(at, x.length, COLUMNS, ROWS);
    }

    @Test
    public void votesOfOneCallMeetAsPlainOnesDoAndNoneOfTheCallBefore() {
        Random random = new Random(3);
        DenseVotes votes = new DenseVotes();
        for (int n : new int[] {0, 1, 2, 50, 4000}) {
            int[] x = new int[n];
            int[] y = new int[n];
            byte[] vote = new byte[n];
            for (int i = 0; i < n; i++) {
                // a part of them beyond any of the four sides
                x[i] = random.nextInt((COLUMNS + 1) * SUB) - SUB;
                y[i] = random.nextInt((ROWS + 1) * SUB) - SUB;
                vote[i] = (byte) (random.nextInt(3) == 0 ? -1 : 1);
            }
            assertEquals(n + " events", plain(x, y, vote), dense(votes, x, y, vote));
        }
    }

    @Test
    public void cellThatHoldsLessThanNothingTakesNothingFromTheOneToItsRight() {
        // an OFF event on one cell, and on the next an ON and an OFF one, which meet: 256 times -256
        int[] x = {SUB, 2 * SUB, 2 * SUB};
        int[] y = {SUB, SUB, SUB};
        assertEquals(-65_536, dense(new DenseVotes(), x, y, new byte[] {-1, 1, -1}));
    }

    @Test
    public void allEventsThatFitMayMeetInOnePlace() {
        int n = 1 << 14;
        int[] x = new int[n];
        int[] y = new int[n];
        byte[] vote = new byte[n];
        Arrays.fill(x, 3 * SUB);
        Arrays.fill(y, 3 * SUB);
        Arrays.fill(vote, (byte) -1);
        // each with all before it: 256² n (n - 1) / 2
        assertEquals(65_536L * n * (n - 1) / 2, dense(new DenseVotes(), x, y, vote));
    }
}
