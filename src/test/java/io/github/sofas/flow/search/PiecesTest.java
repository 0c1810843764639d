package io.github.sofas.flow.search;

import static org.junit.Assert.assertEquals;

import io.github.sofas.flow.SofasParameters;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.junit.Test;

/** Pieces of the slowest projection by hand: cells of 2 px, four events each, all of them within a ms. */
public class PiecesTest {
    private static final double THRESHOLD_SD = 0.5;
    /** All that came a while ago has been taken in, and nothing has been let go. */
    private static final long NOW_US = 300_000;

    private final FlowPlane plane = new FlowPlane(240, 180, SofasParameters.defaults().search());
    private final Pieces pieces = new Pieces(plane);
    private long timeUs;

    private void add(int x, int y) {
        if (plane.events().head() == 0) {
            plane.add(x, y, timeUs, 1);
        } else {
            // past the tiles that are searched, which so many events at once would thin
            plane.events().add(x, y, timeUs, 1);
        }
    }

    private void fill(int fromX, int fromY, int width, int height) {
        for (int y = fromY; y < fromY + height; y++) {
            for (int x = fromX; x < fromX + width; x++) {
                add(x, y);
            }
        }
    }

    /** A frame of two pixels, one cell. */
    private void outline(int fromX, int fromY, int width, int height) {
        fill(fromX, fromY, width, 2);
        fill(fromX, fromY + height - 2, width, 2);
        fill(fromX, fromY + 2, 2, height - 4);
        fill(fromX + width - 2, fromY + 2, 2, height - 4);
    }

    /** Events of each piece of the projection to the right along the slowest ring, which moves by 4 px/s. */
    private List<Integer> found(long nowUs) {
        plane.settle(nowUs);
        int count = pieces.find(0, THRESHOLD_SD);
        List<Integer> sizes = new ArrayList<>();
        for (int piece = 1; piece <= count; piece++) {
            sizes.add(pieces.start(piece + 1) - pieces.start(piece));
        }
        return sizes;
    }

    @Test
    public void outlineStaysOnePiece() {
        // 80 px both ways, but only 156 of 40 x 40 cells
        outline(48, 48, 80, 80);
        assertEquals(List.of(4 * 156), found(NOW_US));
    }

    @Test
    public void filledTextureIsCutIntoPartsOfFortyEightPixels() {
        // 80 px from column and row 48 on, where a part begins: 24 + 16 cells
        fill(48, 48, 80, 80);
        assertEquals(List.of(4 * 24 * 24, 4 * 16 * 24, 4 * 24 * 16, 4 * 16 * 16), found(NOW_US));
    }

    @Test
    public void filledTextureUpToAPartStaysOnePiece() {
        // 24 cells lie on four parts here, and 25 too
        fill(60, 60, 48, 48);
        assertEquals(List.of(4 * 24 * 24), found(NOW_US));
        plane.reset();
        fill(60, 60, 50, 50);
        assertEquals(List.of(4 * 18 * 18, 4 * 7 * 18, 4 * 18 * 7, 4 * 7 * 7), found(NOW_US));
    }

    @Test
    public void longBandOfTextureStaysOnePiece() {
        fill(20, 60, 200, 48);
        assertEquals(List.of(4 * 100 * 24), found(NOW_US));
        plane.reset();
        fill(60, 10, 48, 160);
        assertEquals(List.of(4 * 24 * 80), found(NOW_US));
    }

    @Test
    public void textureAcrossTheSeamIsMeasuredAcrossIt() {
        // a second after the first events, 4 px/s to the right bring columns 0 to 3 before column 0, on the last cells
        // of the torus: 25 cells are columns 126, 127 and 0 to 22, rows 0 to 24; a box from the first column of the
        // torus to the last would be filled too little to be cut
        fill(200, 160, 2, 2);
        timeUs = 1_000_000;
        fill(0, 0, 50, 50);
        List<Integer> sizes = found(1_200_000);
        Collections.sort(sizes);
        assertEquals(List.of(4, 4 * 2, 4 * 23, 4 * 2 * 24, 4 * 23 * 24), sizes);
    }

    @Test
    public void cellsThatTouchAtACornerAreOnePiece() {
        fill(20, 20, 6, 2);
        fill(26, 22, 6, 2);
        fill(40, 20, 2, 2);
        assertEquals(List.of(24, 4), found(NOW_US));
    }

    @Test
    public void cellsBelowTheThresholdBelongToAPieceOnlyBesideIt() {
        // two events a cell are occupied, but three at least stand out
        fill(20, 20, 6, 2);
        fill(26, 20, 4, 1);
        fill(60, 20, 4, 1);
        assertEquals(List.of(12 + 4), found(NOW_US));
    }

    @Test
    public void eventsOfAPieceAreInOrderOfTime() {
        for (int i = 0; i < 4; i++) {
            timeUs = i * 100;
            fill(60, 20, 2, 2);
            fill(20, 20, 2, 2);
        }
        assertEquals(List.of(16, 16), found(NOW_US));
        // the first in the order of cells is that on the left, the second four of each eight events
        for (int i = 0; i < 16; i++) {
            assertEquals(4 + 8 * (i / 4) + i % 4, pieces.events()[pieces.start(1) + i]);
            assertEquals(8 * (i / 4) + i % 4, pieces.events()[pieces.start(2) + i]);
        }
    }

    @Test
    public void projectionWithoutEventsHasNoPieces() {
        assertEquals(List.of(), found(NOW_US));
    }
}
