package io.github.sofas.flow.fit;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import org.junit.Test;

/** What shows of turning and growth beyond a shift: pictures drawn by hand. */
public class StructureTensorTest {
    private static final int PLACES = 360;

    private final StructureTensor tensor = new StructureTensor();

    @Test
    public void nothingIsKnownWithoutAPicture() {
        assertEquals(0, tensor.own(StructureTensor.TURN), 0);
        assertEquals(0, tensor.own(StructureTensor.GROW), 0);
    }

    @Test
    public void ringShowsGrowthAndNoTurning() {
        arc(0, 360, 0, 0);

        assertEquals(0, tensor.own(StructureTensor.TURN), 0.01);
        // neither shift looks like growth: the slopes of opposite sides cancel
        assertEquals(1, tensor.own(StructureTensor.GROW), 0.02);
    }

    @Test
    public void turningOfAnArcAboutItsMiddleIsAShift() {
        // sixty degrees about the x axis, whose middle lies at sin(30 deg) / (30 deg in rad) = 0.955 of the radius:
        // turning about there is turning about the ring's centre, which shows nothing, and a shift
        arc(-30, 30, 0.955, 0);

        assertTrue(tensor.own(StructureTensor.TURN) < 0.1);
    }

    @Test
    public void turningOfARingAboutCentresThatDifferIsAShiftEachTime() {
        // one a quarter of a radius to the right, one as much to the left: either turning is a shift up or down, and
        // that of the mean of both pictures is none
        arc(0, 360, 0.25, 0);
        arc(0, 360, -0.25, 0);

        assertTrue(tensor.own(StructureTensor.TURN) < 0.2);
    }

    @Test
    public void straightEdgeShowsTurningAndNoGrowth() {
        tensor.begin();
        for (int k = 0; k < PLACES; k++) {
            // upright edge through the centre: slopes to the right only
            add(1, 0, 0, 2.0 * k / PLACES - 1);
        }
        tensor.end();

        assertEquals(1, tensor.own(StructureTensor.TURN), 0.02);
        assertEquals(0, tensor.own(StructureTensor.GROW), 0.01);
    }

    @Test
    public void squareShowsBoth() {
        tensor.begin();
        for (int k = 0; k < PLACES; k++) {
            double along = 2.0 * k / PLACES - 1;
            add(1, 0, 1, along);
            add(-1, 0, -1, along);
            add(0, 1, along, 1);
            add(0, -1, along, -1);
        }
        tensor.end();

        assertEquals(1, tensor.own(StructureTensor.TURN), 0.05);
        assertEquals(1, tensor.own(StructureTensor.GROW), 0.02);
    }

    @Test
    public void ringGrowsFromItsMiddleAndAnEdgeFromItself() {
        assertEquals("nothing is known", 0, tensor.growsFromX(), 0);
        arc(0, 360, 0, 0);
        assertEquals(0, tensor.growsFromX(), 0.01);
        assertEquals(0, tensor.growsFromY(), 0.01);
        tensor.restart();
        tensor.begin();
        for (int k = 0; k < PLACES; k++) {
            // upright edge at the right: a growth of 1 moves it as a velocity of 1 does, a tenth of which is noise
            add(1, 0, 1, 2.0 * k / PLACES - 1);
        }
        tensor.end();
        assertEquals(1 / 1.1, tensor.growsFromX(), 0.01);
        assertEquals(0, tensor.growsFromY(), 0.01);
    }

    @Test
    public void noiseOfEitherPictureHasNoPart() {
        tensor.begin();
        for (int k = 0; k < PLACES; k++) {
            double along = 2.0 * k / PLACES - 1;
            // the edge of above, each of whose pictures has a slope along it that the other lacks
            int sign = (k & 1) == 0 ? 1 : -1;
            tensor.add(1, sign, 1, 0, 0, along);
        }
        tensor.end();

        assertEquals(0, tensor.own(StructureTensor.GROW), 0.01);
    }

    @Test
    public void forgetsAllPictures() {
        arc(0, 360, 0, 0);
        tensor.restart();

        assertEquals(0, tensor.own(StructureTensor.GROW), 0);
    }

    /** A part of a ring of radius 1, in degrees, seen from a centre. */
    private void arc(double fromDeg, double toDeg, double centreX, double centreY) {
        tensor.begin();
        for (int k = 0; k < PLACES; k++) {
            double angle = Math.toRadians(fromDeg + (toDeg - fromDeg) * (k + 0.5) / PLACES);
            add(Math.cos(angle), Math.sin(angle), Math.cos(angle) - centreX, Math.sin(angle) - centreY);
        }
        tensor.end();
    }

    private void add(double slopeX, double slopeY, double x, double y) {
        tensor.add(slopeX, slopeY, slopeX, slopeY, x, y);
    }
}
