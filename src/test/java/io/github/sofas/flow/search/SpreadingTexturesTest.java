package io.github.sofas.flow.search;

import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertSame;
import static org.junit.Assert.assertTrue;

import org.junit.Test;

/** When a structure of texture looks around itself again. */
public class SpreadingTexturesTest {
    private final SpreadingTextures textures = new SpreadingTextures();

    /** A structure of a speed, which is tracked or not. */
    private static final class Moving extends StructureThatMoves {
        private boolean tracked = true;

        Moving(double speed) {
            super(speed);
        }

        @Override
        public boolean isTracked() {
            return tracked;
        }
    }

    @Test
    public void structureIsDueOnceInAPixelOfTravel() {
        Moving texture = new Moving(100);
        textures.add(texture, 0);
        assertFalse(textures.isAnyDue(9_999));
        assertNull(textures.due(9_999));
        assertTrue(textures.isAnyDue(10_000));
        assertSame(texture, textures.due(10_000));
        assertNull(textures.due(19_999));
        assertSame(texture, textures.due(20_000));
    }

    @Test
    public void structureIsDueOnceInTwoPixelsOnceItHasLookedFourTimes() {
        Moving texture = new Moving(100);
        textures.add(texture, 0);
        for (int look = 1; look <= 4; look++) {
            assertSame(texture, textures.due(10_000 * look));
        }
        assertNull(textures.due(59_999));
        assertSame(texture, textures.due(60_000));
        assertNull(textures.due(79_999));
        assertSame(texture, textures.due(80_000));
    }

    @Test
    public void eachStructureIsDueInItsOwnTime() {
        Moving slow = new Moving(50);
        Moving fast = new Moving(200);
        textures.add(slow, 0);
        textures.add(fast, 0);
        assertSame(fast, textures.due(5_000));
        assertNull(textures.due(7_500));
        assertSame(fast, textures.due(10_000));
        assertSame(slow, textures.due(20_000));
        assertSame(fast, textures.due(20_000));
        assertNull(textures.due(20_000));
    }

    @Test
    public void whatIsNoLongerTrackedIsForgotten() {
        Moving texture = new Moving(100);
        textures.add(texture, 0);
        texture.tracked = false;
        assertNull(textures.due(20_000));
        texture.tracked = true;
        assertNull(textures.due(40_000));
    }

    @Test
    public void whatStandsStillIsNotDue() {
        textures.add(new Moving(0.5), 0);
        assertNull(textures.due(10_000_000));
    }
}
