package io.github.sofas.evaluate;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.FlowOutput;
import java.util.List;
import java.util.Random;
import org.junit.Test;

public class SharpnessTest {
    private static final SensorSize SENSOR = new SensorSize(32, 32);
    private static final double PIXELS = 32 * 32;
    /** Sum of the squares of a Gaussian of 1 px at whole pixels, 1 / (2 sqrt pi), squared for two dimensions. */
    private static final double LONE_EVENT = 0.282095 * 0.282095;

    private final EventBatch batch = new EventBatch(10_000);
    private final FlowOutput flow = new FlowOutput(10_000);

    private void add(long timeUs, int x, int y, double vx, double vy, int segment) {
        int i = batch.size();
        batch.add(timeUs, x, y, 1);
        flow.vxPxPerS[i] = (float) vx;
        flow.vyPxPerS[i] = (float) vy;
        flow.segment[i] = segment;
    }

    private Sharpness sharpness() {
        Sharpness.Gatherer gatherer = new Sharpness.Gatherer(SENSOR);
        gatherer.add(batch, flow);
        return gatherer.sharpness();
    }

    @Test
    public void measuresTheVarianceOfTheBlurredCounts() {
        add(0, 16, 16, 0, 0, 0);
        // One event, blurred: squares add up to 0.0796, the mean is 1 / 1024.
        assertEquals(LONE_EVENT / PIXELS - 1 / PIXELS / PIXELS, sharpness().windows().get(0).variance(), 1e-7);
    }

    @Test
    public void movesEachEventAlongItsFlowToTheMiddleOfTheWindow() {
        add(0, 10, 16, 40, 0, 1);
        add(100_000, 14, 16, 40, 0, 1);
        // Both meet at x = 12: (2² 0.0796 - 2² / 1024) / 1024. Apart by 4 px they overlap by exp(-4²/4) = 0.0183:
        // (2 0.0796 (1 + 0.0183) - 2² / 1024) / 1024.
        double together = 4 * LONE_EVENT - 4 / PIXELS;
        double apart = 2 * LONE_EVENT * (1 + Math.exp(-4)) - 4 / PIXELS;
        assertEquals(together / apart, sharpness().sharpness(), 2e-3);
    }

    @Test
    public void leavesEventsWithoutFlowWhereTheyAre() {
        add(0, 10, 16, 40, 0, 0);
        add(100_000, 14, 16, 40, 0, 0);
        assertEquals(1, sharpness().sharpness(), 0);
        assertEquals(0, sharpness().eventsWithFlow());
    }

    @Test
    public void countsAnEventForTheNearestPixel() {
        EventPicture picture = new EventPicture(SENSOR);
        picture.add(4.49, 7.5);
        picture.add(-0.5, 0);
        picture.add(-0.51, 0);
        picture.add(31.5, 0);
        assertEquals(1, picture.counts()[8 * 32 + 4], 0);
        assertEquals(1, picture.counts()[0], 0);
        double all = 0;
        for (float count : picture.counts()) {
            all += count;
        }
        assertEquals("those outside are not seen", 2, all, 0);
    }

    @Test
    public void findsTheTranslationThatAllEventsShare() {
        Random random = new Random(5);
        int[][] dots = new int[12][];
        for (int d = 0; d < dots.length; d++) {
            dots[d] = new int[] {8 + random.nextInt(16), 8 + random.nextInt(16)};
        }
        // (40, -30) px/s for 200 ms: 8 px right, 6 px up, an event each 10 ms.
        for (int k = 0; k <= 16; k++) {
            for (int[] dot : dots) {
                add(k * 12_500L, Math.round(dot[0] + k * 0.5f - 4), Math.round(dot[1] - k * 0.375f + 3), 0, 0, 0);
            }
        }
        SharpnessWindow window = sharpness().windows().get(0);
        // Half a pixel of travel: rounding to whole pixels lets less not show.
        assertEquals(40, window.translationVxPxPerS(), 2.6);
        assertEquals(-30, window.translationVyPxPerS(), 2.6);
        assertTrue(window.translationSharpness() > 2);
    }

    @Test
    public void neverFindsATranslationThatIsWorseThanRest() {
        Random random = new Random(6);
        for (int i = 0; i < 400; i++) {
            add(i * 250L, random.nextInt(32), random.nextInt(32), 0, 0, 0);
        }
        for (SharpnessWindow window : sharpness().windows()) {
            assertTrue(window.translatedVariance() >= window.variance());
        }
    }

    @Test
    public void findsWhatLookingThroughAllTravelsFinds() {
        Random random = new Random(7);
        MovedEvents events = new MovedEvents();
        for (int i = 0; i < 200; i++) {
            boolean moves = i % 3 == 0;
            add(i * 1000L, moves ? 6 + i / 20 : random.nextInt(32), moves ? 4 + i % 24 : random.nextInt(32), 0, 0, 0);
            events.add(batch, flow, i);
        }
        EventPicture picture = new EventPicture(SENSOR);
        double best = 0;
        for (double travelX = -16; travelX <= 16; travelX += 0.25) {
            for (double travelY = -16; travelY <= 16; travelY += 0.25) {
                events.drawMovedBy(picture, travelX / 0.199, travelY / 0.199);
                best = Math.max(best, picture.variance());
            }
        }
        SingleTranslation translation = new SingleTranslation(SENSOR);
        translation.find(events);
        assertEquals(best, translation.variance(), 0.01 * best);
    }

    @Test
    public void gainIsAboveOneWhereTwoMoveApart() {
        for (int k = 0; k <= 20; k++) {
            for (int row = 0; row < 6; row++) {
                add(k * 10_000L, 8 + k / 4, 6 + row, 25, 0, 1);
                add(k * 10_000L, 22 - k / 4, 20 + row, -25, 0, 2);
            }
        }
        Sharpness sharpness = sharpness();
        assertTrue(sharpness.hasGain());
        assertTrue("gain " + sharpness.gain(), sharpness.gain() > 1.5);
    }

    @Test
    public void thereIsNoGainOverATranslationThatSharpensNothing() {
        for (int i = 0; i < 20; i++) {
            add(i * 1000L, 16, 16, 100, 0, 1);
        }
        assertFalse(sharpness().hasGain());
        assertTrue(sharpness().sharpness() < 1);
    }

    @Test
    public void aWindowEndsAtAFifthOfAnEventAPixel() {
        // 0.2 of 1024 px are 205 events; one each 100 us passes 20 ms with the 201st.
        for (int i = 0; i < 410; i++) {
            add(i * 100L, i % 32, 5, 0, 0, 0);
        }
        assertEquals(List.of(205L, 205L), sharpness().windows().stream().map(SharpnessWindow::events).toList());
    }

    @Test
    public void aWindowIsNoShorterThan20MsAndShorterThan300() {
        for (int i = 0; i <= 400; i++) {
            add(i * 50L, i % 32, 5, 0, 0, 0);
        }
        add(320_000, 1, 1, 0, 0, 0);
        add(619_999, 1, 1, 0, 0, 0);
        add(620_000, 1, 1, 0, 0, 0);
        List<SharpnessWindow> windows = sharpness().windows();
        assertEquals(List.of(401L, 2L, 1L), windows.stream().map(SharpnessWindow::events).toList());
        assertEquals(List.of(20_000L, 619_999L, 620_000L), windows.stream().map(SharpnessWindow::untilUs).toList());
    }

    @Test
    public void theWholeIsTheRatioOfTheSums() {
        Sharpness sharpness = new Sharpness(List.of(new SharpnessWindow(0, 9, 10, 10, 2, 3, 4, 0, 0),
            new SharpnessWindow(10, 19, 30, 10, 4, 9, 5, 0, 0)));
        assertEquals((3 + 9) / 6.0, sharpness.sharpness(), 1e-12);
        assertEquals((4 + 5) / 6.0, sharpness.translationSharpness(), 1e-12);
        assertEquals(1 / 0.5, sharpness.gain(), 1e-12);
        assertEquals(20 / 40.0, sharpness.shareWithFlow(), 1e-12);
    }

    @Test
    public void windowsDoNotDependOnBatches() {
        Random random = new Random(8);
        for (int i = 0; i < 1000; i++) {
            add(i * 700L, random.nextInt(32), random.nextInt(32), 30, 10, 1);
        }
        Sharpness.Gatherer oneByOne = new Sharpness.Gatherer(SENSOR);
        for (int i = 0; i < batch.size(); i++) {
            EventBatch one = new EventBatch(1);
            one.addAll(batch, i, 1);
            FlowOutput output = new FlowOutput(1);
            output.vxPxPerS[0] = flow.vxPxPerS[i];
            output.vyPxPerS[0] = flow.vyPxPerS[i];
            output.segment[0] = flow.segment[i];
            oneByOne.add(one, output);
        }
        assertEquals(sharpness(), oneByOne.sharpness());
    }

    @Test
    public void keepsPicturesOfTheWindowWithTheMostFlow() {
        add(0, 5, 5, 0, 0, 0);
        add(400_000, 10, 16, 40, 0, 1);
        add(500_000, 14, 16, 40, 0, 1);
        add(900_000, 20, 20, 0, 0, 1);
        Sharpness.Gatherer gatherer = Sharpness.Gatherer.withoutTranslation(SENSOR);
        gatherer.add(batch, flow);
        Sharpness sharpness = gatherer.sharpness();
        assertEquals(400_000, gatherer.fullest().window().fromUs());
        assertEquals(1, gatherer.fullest().before()[16 * 32 + 10], 0);
        assertEquals("both at x = 12", 2, gatherer.fullest().after()[16 * 32 + 12], 0);
        assertFalse("nothing was searched", sharpness.hasGain());
        assertEquals(sharpness().sharpness(), sharpness.sharpness(), 0);
    }

    @Test
    public void noEventsAreAsSharpAsTheyAre() {
        assertEquals(1, sharpness().sharpness(), 0);
        assertEquals(0, sharpness().windows().size());
    }
}
