package io.github.sofas.simulate;

import static org.junit.Assert.assertEquals;

import io.github.sofas.simulate.Shape.Box;
import io.github.sofas.simulate.Shape.Capsule;
import io.github.sofas.simulate.Shape.Disc;
import io.github.sofas.simulate.Shape.RegularPolygon;
import io.github.sofas.simulate.Shape.Union;
import org.junit.Test;

public class ShapeTest {
    private static final double EXACT = 1e-9;

    @Test
    public void discMeasuresFromItsRim() {
        Shape disc = new Disc(5);
        assertEquals(-5, disc.signedDistance(0, 0), EXACT);
        assertEquals(5, disc.signedDistance(6, 8), EXACT);
    }

    @Test
    public void boxMeasuresFromSidesAndCorners() {
        Shape box = new Box(1, 0, 6, 4);
        // Sides at x = -2 and 4, y = -2 and 2.
        assertEquals(-2, box.signedDistance(1, 0), EXACT);
        assertEquals(3, box.signedDistance(7, 1), EXACT);
        assertEquals(5, box.signedDistance(7, 6), EXACT);
        assertEquals(Math.sqrt(20), box.radius(), EXACT);
        assertEquals(4, box.reachRight(0), EXACT);
        assertEquals(2, box.reachDown(0), EXACT);
    }

    @Test
    public void capsuleHasRoundEnds() {
        Shape capsule = new Capsule(10, 4);
        // The line ends at x = 3; (6, 4) is 5 from there.
        assertEquals(-2, capsule.signedDistance(2, 0), EXACT);
        assertEquals(3, capsule.signedDistance(6, 4), EXACT);
        assertEquals(5, capsule.reachRight(0), EXACT);
        assertEquals(2, capsule.reachDown(0), EXACT);
    }

    @Test
    public void hexagonHasItsCornersOnTheAxisOfX() {
        Shape hexagon = new RegularPolygon(6, 10);
        double inner = 10 * Math.sqrt(3) / 2;
        assertEquals(0, hexagon.signedDistance(10, 0), EXACT);
        assertEquals(4, hexagon.signedDistance(14, 0), EXACT);
        assertEquals(-inner, hexagon.signedDistance(0, 0), EXACT);
        assertEquals(2, hexagon.signedDistance(0, inner + 2), EXACT);
        assertEquals(10, hexagon.reachRight(0), EXACT);
        assertEquals(inner, hexagon.reachDown(0), EXACT);
    }

    @Test
    public void unionIsAsNearAsItsNearestPart() {
        Shape both = new Union(new Box(-10, 0, 4, 4), new Box(10, 0, 4, 4));
        assertEquals(8, both.signedDistance(0, 0), EXACT);
        assertEquals(-2, both.signedDistance(10, 0), EXACT);
        assertEquals(12, both.reachRight(0), EXACT);
    }
}
