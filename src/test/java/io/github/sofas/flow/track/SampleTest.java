package io.github.sofas.flow.track;

import static org.junit.Assert.assertEquals;

import java.util.ArrayList;
import java.util.List;
import org.junit.Test;

/** Which live events are measured; how many, {@link MeasurementTest} shows. */
public class SampleTest {
    @Test
    public void sampleIsFourStretchesFromTheFirstEventToTheLast() {
        List<Integer> numbers = new ArrayList<>();
        for (int k = 0; k < 8; k++) {
            numbers.add(Sample.number(k, 8, 20));
        }
        // 12 left out, in three gaps of 4
        assertEquals(List.of(0, 1, 6, 7, 12, 13, 18, 19), numbers);
        // where all are wanted each is taken once
        for (int k = 0; k < 10; k++) {
            assertEquals(k, Sample.number(k, 10, 10));
        }
    }
}
