package io.github.sofas.evaluate;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;

import org.junit.Test;

public class AgreementTest {
    @Test
    public void comparesEventsThatBothGaveFlow() {
        // second event: (3, 4) against (0, 4), 3 px/s apart, atan(3 / 4) = 36.87 degrees; third: equal
        FlowEstimate a = FlowEstimate.of(new float[] {1, 3, 2, 5}, new float[] {0, 4, 0, 0}, new int[] {1, 1, 1, 0});
        FlowEstimate b = FlowEstimate.of(new float[] {0, 0, 2, 5}, new float[] {0, 4, 0, 0}, new int[] {0, 1, 1, 1});
        Agreement agreement = Agreement.of(a, b);
        assertEquals(2, agreement.both());
        assertEquals(1.5, agreement.difference().mean(), 1e-9);
        assertEquals(36.8699 / 2, agreement.angle().mean(), 1e-4);
    }

    @Test
    public void refusesEstimatesOfDifferentEvents() {
        FlowEstimate one = FlowEstimate.of(new float[1], new float[1], new int[1]);
        assertEquals("estimates must be of equally many events but have 1 and 0",
            assertThrows(IllegalArgumentException.class, () -> Agreement.of(one, new FlowEstimate())).getMessage());
    }
}
