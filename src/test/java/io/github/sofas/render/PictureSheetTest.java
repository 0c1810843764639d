package io.github.sofas.render;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.GreyFrame;
import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.FlowOutput;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Random;
import org.junit.Test;

/** Panels of 40 x 30 px at scale 4: the first begins at column 8, row 24 of the picture. */
public class PictureSheetTest {
    private static final SensorSize SENSOR = new SensorSize(40, 30);
    private static final FlowColours FLOW = new FlowColours(FlowColours.Wheel.SAFE, Theme.DARK);

    private static PictureOptions options(Panel... panels) {
        return new PictureOptions(List.of(panels), Theme.DARK, FlowColours.Wheel.SAFE, 4, 10_000, 0, 100, null);
    }

    /** One event at (10, 20) at 5 ms. */
    private static PictureSheet withEvent(PictureOptions options, int polarity, float vx, float vy, int segment) {
        PictureSheet sheet = new PictureSheet(SENSOR, options);
        EventBatch batch = new EventBatch(1);
        FlowOutput flow = new FlowOutput(1);
        batch.add(5_000, 10, 20, polarity);
        flow.vxPxPerS[0] = vx;
        flow.vyPxPerS[0] = vy;
        flow.segment[0] = segment;
        sheet.add(batch, flow, 0, 1);
        return sheet;
    }

    private static int rgb(BufferedImage picture, int x, int y) {
        return picture.getRGB(x, y) & 0xFFFFFF;
    }

    @Test
    public void eventFillsItsPixelAndNoOther() {
        BufferedImage picture = withEvent(options(Panel.EVENTS), 1, 0, 0, 0).paint(6_000, 6_000, null);
        // column 8 + 10 x 4, row 24 + 20 x 4
        for (int x = 46; x < 54; x++) {
            for (int y = 102; y < 110; y++) {
                boolean inside = x >= 48 && x < 52 && y >= 104 && y < 108;
                assertEquals(x + "," + y, inside ? Theme.DARK.on : Theme.DARK.sensor, rgb(picture, x, y));
            }
        }
    }

    @Test
    public void eventIsShownWhileItIsExposed() {
        PictureSheet sheet = withEvent(options(Panel.EVENTS), -1, 0, 0, 0);
        assertEquals(Theme.DARK.off, rgb(sheet.paint(14_999, 0, null), 48, 104));
        assertEquals(Theme.DARK.sensor, rgb(sheet.paint(15_000, 0, null), 48, 104));
    }

    @Test
    public void exposureByCountShowsTheLastEvents() {
        PictureSheet sheet = new PictureSheet(SENSOR, new PictureOptions(List.of(Panel.EVENTS), Theme.DARK,
            FlowColours.Wheel.SAFE, 4, 0, 2, 100, null));
        EventBatch batch = new EventBatch(3);
        for (int i = 0; i < 3; i++) {
            batch.add(0, i, 0, 1);
        }
        sheet.add(batch, new FlowOutput(3), 0, 3);
        BufferedImage picture = sheet.paint(1_000_000, 0, null);
        assertEquals(Theme.DARK.sensor, rgb(picture, 8, 24));
        assertEquals(Theme.DARK.on, rgb(picture, 12, 24));
        assertEquals(Theme.DARK.on, rgb(picture, 16, 24));
    }

    @Test
    public void flowHasTheColourOfItsVelocity() {
        BufferedImage picture = withEvent(options(Panel.FLOW), 1, 0, -50, 3).paint(6_000, 0, null);
        assertEquals(FLOW.rgb(0, -50, 100), rgb(picture, 48, 104));
    }

    /** Twenty events with flow at 300 px/s in each picture: fewer than ever gave a scale before. */
    @Test
    public void fullColourFollowsTheSpeedOfFewEvents() {
        PictureSheet sheet = new PictureSheet(SENSOR, new PictureOptions(List.of(Panel.FLOW), Theme.DARK,
            FlowColours.Wheel.SAFE, 4, 10_000, 0, 0, null));
        EventBatch some = new EventBatch(20);
        FlowOutput flow = new FlowOutput(20);
        for (int i = 0; i < 20; i++) {
            some.add(5_000, i, 20, 1);
            flow.segment[i] = 1;
            flow.vxPxPerS[i] = 300;
        }
        sheet.add(some, flow, 0, 20);
        assertEquals(FLOW.rgb(300, 0, 500), rgb(sheet.paint(6_000, 0, null), 8 + 2, 24 + 20 * 4 + 2));
    }

    @Test
    public void fullColourFollowsTheSpeedOfOneEventAPictureInTime() {
        PictureSheet sheet = new PictureSheet(SENSOR, new PictureOptions(List.of(Panel.FLOW), Theme.DARK,
            FlowColours.Wheel.SAFE, 4, 10_000, 0, 0, null));
        EventBatch one = new EventBatch(1);
        FlowOutput flow = new FlowOutput(1);
        flow.segment[0] = 1;
        flow.vxPxPerS[0] = 90;
        BufferedImage picture = null;
        for (int k = 0; k < 30; k++) {
            one.clear();
            one.add(10_000L * k, 5, 20, 1);
            sheet.add(one, flow, 0, 1);
            picture = sheet.paint(10_000L * k + 1, 0, null);
        }
        // 1 + 0.95 + 0.95² + ... passes 12 with the 18th picture
        assertEquals(FLOW.rgb(90, 0, 100), rgb(picture, 8 + 5 * 4, 24 + 20 * 4));
    }

    /** A panel full of one segment: its name and its arrow are of another colour than all about them. */
    @Test
    public void nameAndArrowAreSeenOnEventsOfTheirOwnColour() {
        PictureSheet sheet = new PictureSheet(SENSOR, options(Panel.SEGMENTS));
        sheet.colour(7, 5);
        EventBatch all = new EventBatch(40 * 30);
        FlowOutput flow = new FlowOutput(40 * 30);
        for (int i = 0; i < 40 * 30; i++) {
            all.add(5_000, i % 40, i / 40, 1);
            flow.segment[i] = 7;
            flow.vxPxPerS[i] = 100;
        }
        sheet.add(all, flow, 0, all.size());
        BufferedImage panel = sheet.paint(6_000, 0, null).getSubimage(8, 24, 160, 120);
        // place 5 of the dark theme is white, as good as the text: black must part them
        int white = Theme.DARK.segmentColour(5);
        int black = 0;
        for (int x = 0; x < 160; x++) {
            for (int y = 0; y < 120; y++) {
                int rgb = rgb(panel, x, y);
                black += rgb == Theme.DARK.sensor ? 1 : 0;
            }
        }
        assertEquals(0xFFFFFF, white);
        assertTrue(black + " pixels of the ground's colour", black > 50);
    }

    @Test
    public void eventWithoutFlowIsGrey() {
        BufferedImage picture = withEvent(options(Panel.FLOW, Panel.SEGMENTS), 1, 0, 0, 0).paint(6_000, 0, null);
        assertEquals(Theme.DARK.faint, rgb(picture, 48, 104));
        // the second panel begins 40 x 4 + 8 further right
        assertEquals(Theme.DARK.faint, rgb(picture, 48 + 168, 104));
    }

    @Test
    public void frameIsShownWithItsContrastStretched() {
        PictureSheet sheet = new PictureSheet(SENSOR, options(Panel.GREY));
        assertEquals(Theme.DARK.sensor, rgb(sheet.paint(0, 0, null), 8, 24));
        // columns 0 to 19 at 100, 20 to 39 at 150: black and white, all that is there
        byte[] levels = new byte[40 * 30];
        for (int i = 0; i < levels.length; i++) {
            levels[i] = (byte) (i % 40 < 20 ? 100 : 150);
        }
        levels[0] = 125;
        sheet.show(new GreyFrame(0, 40, 30, levels));
        BufferedImage picture = sheet.paint(0, 0, null);
        // 255 x 25 / 50
        assertEquals(0x7F7F7F, rgb(picture, 8, 24));
        assertEquals(0x000000, rgb(picture, 8 + 4, 24));
        assertEquals(0xFFFFFF, rgb(picture, 8 + 20 * 4, 24));
    }

    @Test
    public void frameOfAnotherSizeIsRefused() {
        PictureSheet sheet = new PictureSheet(SENSOR, options(Panel.GREY));
        assertEquals("frame must be of the sensor's size 40x30 but was 1x1", assertThrows(
            IllegalArgumentException.class, () -> sheet.show(new GreyFrame(0, 1, 1, new byte[1]))).getMessage());
    }

    @Test
    public void cropShowsItsPartOnly() {
        PictureOptions options = new PictureOptions(List.of(Panel.EVENTS), Theme.DARK, FlowColours.Wheel.SAFE, 4,
            10_000, 0, 100, new PictureOptions.Crop(10, 20, 5, 5));
        assertEquals(Theme.DARK.on, rgb(withEvent(options, 1, 0, 0, 0).paint(6_000, 0, null), 8, 24));
    }

    @Test
    public void cropBesideTheSensorIsRefused() {
        PictureOptions options = new PictureOptions(List.of(Panel.EVENTS), Theme.DARK, FlowColours.Wheel.SAFE, 4,
            10_000, 0, 100, new PictureOptions.Crop(36, 0, 5, 5));
        assertEquals("crop must lie on the sensor of 40x30 but was 36,0,5,5",
            assertThrows(IllegalArgumentException.class, () -> new PictureSheet(SENSOR, options)).getMessage());
    }

    /** Events of ten pictures, each of which is also painted by a sheet that has painted none before. */
    @Test
    public void pictureDoesNotDependOnThoseBefore() {
        PictureOptions options = options(Panel.FLOW, Panel.SEGMENTS);
        PictureSheet sheet = new PictureSheet(SENSOR, options);
        sheet.colour(1, 0);
        sheet.colour(2, 1);
        EventBatch all = new EventBatch(2_000);
        FlowOutput flow = new FlowOutput(2_000);
        Random random = new Random(5);
        for (int i = 0; i < 2_000; i++) {
            // two segments, 100 us an event, 200 events a picture
            int segmentId = 1 + i / 3 % 2;
            all.add(i * 100L, (10 + 15 * segmentId + random.nextInt(12)) % 40, random.nextInt(30), 1);
            flow.segment[i] = segmentId;
            flow.vxPxPerS[i] = 80 - 50 * segmentId;
            flow.vyPxPerS[i] = i / 20.0f;
        }
        for (int k = 1; k <= 10; k++) {
            sheet.add(all, flow, 200 * (k - 1), 200 * k);
            int[] rgb = pixels(sheet.paint(20_000L * k, 20_000L * k, null));
            PictureSheet fresh = new PictureSheet(SENSOR, options);
            fresh.colour(1, 0);
            fresh.colour(2, 1);
            fresh.add(all, flow, 0, 200 * k);
            assertArrayEquals("picture " + k, pixels(fresh.paint(20_000L * k, 20_000L * k, null)), rgb);
        }
    }

    private static int[] pixels(BufferedImage picture) {
        return picture.getRGB(0, 0, picture.getWidth(), picture.getHeight(), null, 0, picture.getWidth());
    }

    @Test
    public void sidesAreMultiplesOfTheCodecsBlocks() {
        for (int scale = 1; scale <= 5; scale++) {
            BufferedImage picture = new PictureSheet(SENSOR, options(Panel.EVENTS).withScale(scale)).paint(0, 0, null);
            assertEquals(0, picture.getWidth() % 16);
            assertEquals(0, picture.getHeight() % 16);
        }
    }
}
