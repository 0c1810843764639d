package io.github.sofas.simulate;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.Test;

public class PixelArrayTest {
    private final List<String> events = new ArrayList<>();

    private PixelArray onePixel(DvsModel model) {
        PixelArray pixels = new PixelArray(1, model, new Random(1));
        // log 1 = 0
        pixels.restart(new double[] {1});
        return pixels;
    }

    private void change(PixelArray pixels, double logLight, double fromUs, double toUs) {
        pixels.change(0, logLight, fromUs, toUs,
                (pixel, timeUs, polarity) -> events.add(Math.round(timeUs) + (polarity > 0 ? " ON" : " OFF")));
    }

    @Test
    public void firesOnceForEveryThresholdCrossedAtTheInterpolatedTime() {
        PixelArray pixels = onePixel(DvsModel.ideal());
        // From 0 to 0.7 in 700 us: levels 0.2, 0.4 and 0.6 are met after 200, 400 and 600 us; floor(0.7 / 0.2) = 3.
        change(pixels, 0.7, 1000, 1700);
        assertEquals(List.of("1200 ON", "1400 ON", "1600 ON"), events);
    }

    @Test
    public void remembersTheLevelOfItsLastEvent() {
        PixelArray pixels = onePixel(DvsModel.ideal());
        change(pixels, 0.7, 0, 700);
        events.clear();
        // It remembers 0.6, so the way down meets 0.4, 0.2 and 0, 0.3, 0.5 and 0.7 below the start.
        change(pixels, 0, 1000, 1700);
        assertEquals(List.of("1300 OFF", "1500 OFF", "1700 OFF"), events);
    }

    @Test
    public void staysSilentBelowTheThreshold() {
        PixelArray pixels = onePixel(DvsModel.ideal());
        change(pixels, 0.19, 0, 100);
        change(pixels, -0.19, 100, 200);
        assertTrue(events.isEmpty());
    }

    @Test
    public void addsUpSmallChangesOverManySteps() {
        PixelArray pixels = onePixel(DvsModel.ideal());
        for (int i = 1; i <= 50; i++) {
            change(pixels, 0.01 * i + 0.005, 100 * (i - 1), 100 * i);
        }
        // 0.505 in all: 0.2 and 0.4 are crossed, the first in step 20 from 0.195 to 0.205 after half of its 100 us.
        assertEquals(List.of("1950 ON", "3950 ON"), events);
    }

    @Test
    public void isBlindForTheRefractoryTimeAndComparesWithTheLightAtItsEnd() {
        PixelArray pixels = onePixel(DvsModel.ideal().withRefractoryUs(100));
        // Rises by 0.001 per us: event at 200, sees again at 300 with 0.3, so the next is at 0.5, then 0.8.
        change(pixels, 0.9, 0, 900);
        assertEquals(List.of("200 ON", "500 ON", "800 ON"), events);
    }

    @Test
    public void staysBlindAcrossSteps() {
        PixelArray pixels = onePixel(DvsModel.ideal().withRefractoryUs(100));
        change(pixels, 0.25, 0, 250);
        change(pixels, 0.28, 250, 280);
        change(pixels, 0.9, 280, 900);
        assertEquals(List.of("200 ON", "500 ON", "800 ON"), events);
    }

    @Test
    public void firesNoNoiseWhileBlind() {
        PixelArray pixels = onePixel(DvsModel.ideal().withRefractoryUs(100));
        assertTrue(pixels.fireUnprompted(0, 1000));
        assertFalse(pixels.fireUnprompted(0, 1099));
        assertTrue(pixels.fireUnprompted(0, 1100));
    }

    @Test
    public void usesItsOwnThresholdForEachPolarity() {
        PixelArray pixels = onePixel(DvsModel.ideal().withThresholds(0.5, 0.25));
        change(pixels, 1.1, 0, 1100);
        change(pixels, 0.4, 2000, 2700);
        // Up: 0.5 and 1.0. Down from remembered 1.0: 0.75 and 0.5, 0.35 and 0.6 below 1.1.
        assertEquals(List.of("500 ON", "1000 ON", "2350 OFF", "2600 OFF"), events);
    }
}
