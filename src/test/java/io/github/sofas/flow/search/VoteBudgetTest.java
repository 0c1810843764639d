package io.github.sofas.flow.search;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import org.junit.Test;

/**
 * What the search may spend: 120 votes per event, less up to 40 of those that measurements gave, and 100 per µs between
 * events.
 */
public class VoteBudgetTest {
    private final VoteBudget budget = new VoteBudget(1_000);

    /** How many events must be earned until votes are left. */
    private int eventsUntilLeft(long measuringVotes) {
        int events = 0;
        while (!budget.isLeft()) {
            budget.earn(measuringVotes, 0);
            events++;
        }
        return events;
    }

    /** Spends what is left: so many votes, and no more. */
    private void assertLeft(long votes) {
        budget.spend(votes - 1);
        assertTrue(budget.isLeft());
        budget.spend(1);
        assertFalse(budget.isLeft());
    }

    @Test
    public void eachEventEarnsAHundredAndTwentyVotes() {
        budget.earn(1_000, 0);
        assertLeft(120);
    }

    @Test
    public void whatIsSpentTooMuchIsPaidByTheEventsThatFollow() {
        budget.spend(1_200);
        // with the tenth nothing is left, with the eleventh 120
        assertEquals(11, eventsUntilLeft(1_000));
    }

    @Test
    public void measurementsArePaidFirst() {
        // 30 votes are paid, 90 left
        budget.earn(1_030, 0);
        assertLeft(90);
    }

    @Test
    public void twoThirdsAreLeftHoweverMuchMeasurementsOwe() {
        budget.earn(1_000_000, 0);
        assertLeft(80);
    }

    @Test
    public void noMoreIsOwedThanAHundredThousand() {
        budget.earn(1_000_000, 0);
        budget.spend(80);
        // 40 of 100,000 are paid with each of 2,500 events, one of which was
        budget.spend(2_499 * 80);
        assertEquals(2_500, eventsUntilLeft(1_000_000));
    }

    @Test
    public void noMoreIsSavedThanFortyThousand() {
        for (int i = 0; i < 1_000; i++) {
            budget.earn(1_000, 0);
        }
        assertLeft(40_000);
    }

    @Test
    public void eachMicrosecondBetweenEventsEarnsAHundredVotes() {
        budget.earn(1_000, 0);
        budget.earn(1_000, 7);
        assertLeft(2 * 120 + 700);
    }

    @Test
    public void longPauseEarnsAsMuchAsAHundredMicroseconds() {
        budget.earn(1_000, 0);
        budget.earn(1_000, 1_000_000);
        assertLeft(2 * 120 + 10_000);
    }

    @Test
    public void timeThatGoesBackEarnsNothing() {
        budget.earn(1_000, 50);
        budget.spend(120 + 5_000);
        budget.earn(1_000, 10);
        assertLeft(120);
    }

    @Test
    public void clearedBudgetEarnsAsANewOne() {
        budget.earn(1_000, 1_000_000);
        budget.clear();
        budget.earn(1_000, 50);
        // as the first event of a new one: the time from 0 on
        assertLeft(120 + 5_000);
    }

    @Test
    public void clearedBudgetOwesNothing() {
        budget.earn(5_000, 0);
        budget.clear();
        assertFalse(budget.isLeft());
        budget.earn(5_000, 0);
        assertLeft(120);
    }
}
