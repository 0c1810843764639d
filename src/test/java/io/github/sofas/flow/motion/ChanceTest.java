package io.github.sofas.flow.motion;

import static org.junit.Assert.assertEquals;

import org.junit.Test;

public class ChanceTest {
    private static final double EXACT = 1e-12;

    @Test
    public void shareIsALittleLessThanThatOfAPoissonProcess() {
        assertEquals(0.2, Chance.share(0.25), EXACT);
        assertEquals(0.9, Chance.share(0.25) / (1 - Math.exp(-0.25)), 0.01);
        assertEquals(0.8, Chance.share(0.75) / (1 - Math.exp(-0.75)), 0.02);
        assertEquals(0, Chance.share(0), EXACT);
    }

    @Test
    public void variancesOfPartsAddUp() {
        // four parts of mean 1 and variance 10 - 1: 4 and 36 = 6², of which two are 12
        assertEquals(16, Chance.most(4, 1, 10, 2), EXACT);
    }
}
