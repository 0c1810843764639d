package io.github.sofas.flow.track;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.Before;
import org.junit.Test;

public class PartingScheduleTest {
    private final PartingSchedule schedule = new PartingSchedule();

    @Before
    public void begin() {
        schedule.start(0);
    }

    @Test
    public void structureIsAskedEachFourPixels() {
        // 100 px/s travel 4 px in 40 ms
        assertFalse(schedule.isDue(100, 39_999));
        assertTrue(schedule.isDue(100, 40_000));
        schedule.begin(40_000);
        assertFalse(schedule.isDue(100, 79_999));
        assertTrue(schedule.isDue(100, 80_000));
    }

    /** Numbers of the times, of so many, at which it is asked whether it is two; the answer is the same each time. */
    private List<Integer> askedForTwo(int times, boolean isClearlyOne) {
        List<Integer> asked = new ArrayList<>();
        for (int k = 1; k <= times; k++) {
            schedule.begin(0);
            if (schedule.isForTwo()) {
                asked.add(k);
                schedule.note(isClearlyOne);
            }
        }
        return asked;
    }

    @Test
    public void whatIsClearlyOneIsAskedHalfAsOftenUpToEachEighthTime() {
        assertEquals(List.of(1, 3, 7, 15, 23), askedForTwo(24, true));
    }

    @Test
    public void whatIsNotIsAskedEachTime() {
        assertEquals(List.of(1, 2, 3), askedForTwo(3, false));
    }

    @Test
    public void whatBecameAnotherIsAskedSoonAgain() {
        assertEquals(List.of(1, 3, 7), askedForTwo(8, true));
        schedule.askSoonForTwo();
        assertEquals(List.of(1, 3), askedForTwo(4, true));
    }

    @Test
    public void questionThatCouldNotBeAskedIsAskedTheNextTime() {
        schedule.begin(0);
        assertTrue(schedule.isForTwo());
        schedule.begin(0);
        assertTrue(schedule.isForTwo());
    }
}
