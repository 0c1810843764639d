package io.github.sofas.flow.motion;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import org.junit.Test;

public class BoundsTest {
    private final Bounds bounds = new Bounds();

    private void assertSides(double left, double top, double right, double bottom) {
        assertEquals(left, bounds.left(), 0);
        assertEquals(top, bounds.top(), 0);
        assertEquals(right, bounds.right(), 0);
        assertEquals(bottom, bounds.bottom(), 0);
    }

    @Test
    public void boxHoldsItsPlacesAndNoMore() {
        bounds.include(3, -2);
        assertSides(3, -2, 3, -2);
        bounds.include(-1.5, 7);
        bounds.include(0, 0);
        assertSides(-1.5, -2, 3, 7);
    }

    @Test
    public void boxThatIsClearedHoldsNoPlace() {
        assertTrue(bounds.left() > bounds.right() && bounds.top() > bounds.bottom());
        bounds.include(3, -2);
        bounds.clear();
        assertTrue(bounds.left() > bounds.right() && bounds.top() > bounds.bottom());
        bounds.include(5, 6);
        assertSides(5, 6, 5, 6);
    }
}
