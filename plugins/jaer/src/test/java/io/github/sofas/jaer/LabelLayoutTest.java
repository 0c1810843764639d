package io.github.sofas.jaer;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNotNull;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.Test;

public class LabelLayoutTest {
    private final LabelLayout layout = new LabelLayout(200, 100);

    @Test
    public void labelLiesAboveWhatItNames() {
        assertEquals(new Box(50, 33, 90, 43), layout.place(new Box(50, 20, 60, 30), 40, 10));
    }

    @Test
    public void labelOfATallStructureLiesBesideIt() {
        // neither above nor below is in the picture: right of it, at its upper end
        assertEquals(new Box(63, 90, 103, 100), layout.place(new Box(50, 0, 60, 100), 40, 10));
    }

    @Test
    public void labelIsMovedSidewaysIntoThePicture() {
        assertEquals(new Box(160, 33, 200, 43), layout.place(new Box(190, 20, 198, 30), 40, 10));
    }

    @Test
    public void neighboursDoNotOverlap() {
        Box first = layout.place(new Box(50, 20, 60, 30), 40, 10);
        Box second = layout.place(new Box(55, 20, 65, 30), 40, 10);
        assertFalse(first.overlaps(second));
        // below instead of above
        assertEquals(new Box(55, 7, 95, 17), second);
    }

    @Test
    public void whatWasTakenIsKeptFree() {
        layout.take(new Box(0, 30, 200, 100));
        Box label = layout.place(new Box(50, 20, 60, 30), 40, 10);
        assertTrue(label.top() <= 30);
    }

    @Test
    public void labelIsLeftOutWhereThereIsNoPlace() {
        layout.take(new Box(0, 0, 200, 100));
        assertNull(layout.place(new Box(50, 20, 60, 30), 40, 10));
    }

    @Test
    public void manyLabelsAreAllInThePictureAndApart() {
        LabelLayout large = new LabelLayout(800, 600);
        Random random = new Random(1);
        List<Box> placed = new ArrayList<>();
        for (int i = 0; i < 40; i++) {
            float x = random.nextFloat() * 700;
            float y = random.nextFloat() * 500;
            Box box = large.place(Box.of(x, y, 100 * random.nextFloat(), 100 * random.nextFloat()), 120, 15);
            assertNotNull(box);
            assertTrue(box.left() >= 0 && box.right() <= 800 && box.bottom() >= 0 && box.top() <= 600);
            for (Box other : placed) {
                assertFalse(box.overlaps(other));
            }
            placed.add(box);
        }
    }

    @Test
    public void insetLiesBesideTheSensorWhereThereIsRoom() {
        // a picture of 800 x 400, the sensor in its middle: 200 pixels on both sides
        View view = new View(2, 2, 200, 0, 800, 400);
        assertEquals(new Box(676, 4, 796, 124), MetricInset.place(view, new Box(200, 0, 600, 400), 15));
        // below it
        view = new View(2, 2, 0, 200, 400, 800);
        assertEquals(new Box(276, 4, 396, 124), MetricInset.place(view, new Box(0, 200, 400, 600), 15));
    }

    @Test
    public void insetLiesOnTheSensorWhereThereIsNone() {
        View view = new View(2, 2, 10, 10, 420, 420);
        assertEquals(new Box(286, 14, 406, 134), MetricInset.place(view, new Box(10, 10, 410, 410), 15));
    }
}
