package io.github.sofas.flow.motion;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
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

    @Test
    public void placesAreAroundItUpToTheMargin() {
        bounds.set(10, 20, 14, 30);
        assertSides(10, 20, 14, 30);
        assertTrue(bounds.isAround(12, 25, 0));
        assertTrue("a corner", bounds.isAround(14, 30, 0));
        assertTrue(bounds.isAround(8, 32, 2));
        assertFalse(bounds.isAround(7.9, 25, 2));
        assertFalse(bounds.isAround(12, 32.1, 2));
        bounds.clear();
        assertFalse("of no place", bounds.isAround(12, 25, 100));
    }

    @Test
    public void shareOnASensorIsThatOfThePixels() {
        bounds.set(2, 3, 5, 3);
        assertEquals("four pixels in a row", 1, bounds.shareOn(10, 10), 0);
        assertEquals("two of them", 0.5, bounds.shareOn(4, 10), 0);
        assertEquals("no row", 0, bounds.shareOn(10, 3), 0);
        bounds.set(-2, -5, 1, 4);
        assertEquals("half of each side", 0.25, bounds.shareOn(10, 10), 0);
        bounds.set(12, 3, 14, 4);
        assertEquals("beyond", 0, bounds.shareOn(10, 10), 0);
    }

    @Test
    public void boxesAreApartByTheGreaterOfTheirTwoGaps() {
        bounds.set(10, 20, 14, 30);
        Bounds other = new Bounds();
        other.set(17, 34, 18, 35);
        assertTrue(bounds.isWithin(4, other));
        assertTrue(other.isWithin(4, bounds));
        assertFalse("4 px apart in y", bounds.isWithin(3.9, other));
        other.set(11, 21, 13, 22);
        assertTrue("within it", bounds.isWithin(0, other));
        other.set(-20, 20, 5, 30);
        assertFalse("5 px apart in x", bounds.isWithin(4.9, other));
        assertFalse(other.isWithin(4.9, bounds));
    }
}
