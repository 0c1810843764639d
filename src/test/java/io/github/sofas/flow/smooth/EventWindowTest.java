package io.github.sofas.flow.smooth;

import static org.junit.Assert.assertEquals;

import java.util.Random;
import org.junit.Test;

public class EventWindowTest {
    @Test
    public void eventsKeepTheirNumbersHoweverTheRingTurnsAndGrows() {
        EventWindow window = new EventWindow();
        Random random = new Random(7);
        long first = 0;
        for (int round = 0; round < 60; round++) {
            int more = random.nextInt(12_000);
            for (int i = 0; i < more; i++) {
                long number = window.end();
                int k = window.add(3 * number, 3 * number - 1, (int) (number % 300), (int) (number % 200),
                    number % 2 == 0 ? 1 : -1);
                window.segment[k] = (int) number;
            }
            for (long i = first; i < window.end(); i += 1 + random.nextInt(500)) {
                int k = window.at(i);
                assertEquals(3 * i, window.timeUs[k]);
                assertEquals(3 * i - 1, window.givenUs[k]);
                assertEquals(i % 300, window.x[k]);
                assertEquals(i % 200, window.y[k]);
                assertEquals(i % 2 == 0 ? 1 : -1, window.polarity[k]);
                assertEquals(i, window.segment[k]);
            }
            first = Math.min(window.end(), first + random.nextInt(10_000));
            window.forget(first);
        }
    }
}
