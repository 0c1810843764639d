package io.github.sofas.flow.search;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import io.github.sofas.flow.PlainPlane.Event;
import io.github.sofas.flow.SofasParameters;
import io.github.sofas.flow.Streams;
import io.github.sofas.flow.fit.MetricFit;
import java.util.ArrayList;
import java.util.List;
import org.junit.Test;

/** Which structure that is tracked a piece of the flow plane is a part of, and when it is shown that. */
public class RecognitionTest {
    private static final int WIDTH = 64;
    private static final int HEIGHT = 48;
    private static final int ROWS = 30;
    private static final int COLUMNS = 9;
    private static final int EVENTS = ROWS * COLUMNS;
    private static final SofasParameters P = SofasParameters.defaults();

    private final FlowPlane plane = new FlowPlane(WIDTH, HEIGHT, P.search());
    private final int[] numbers = new int[EVENTS];
    private final List<Integer> seenBy = new ArrayList<>();
    private final Recognition recognition = new Recognition(new Seeing(), plane.events());

    /** Knows nothing by itself, and notes which structures see events. */
    private final class Seeing extends StructureThatMoves {
        Seeing() {
            super(0);
        }

        @Override
        public Structure create(long nowUs, double vxPxPerS, double vyPxPerS) {
            throw new AssertionError("nothing is to be made");
        }

        @Override
        public void see(int id, int x, int y, long timeUs, int polarity, long nowUs) {
            seenBy.add(id);
        }
    }

    private void know(int id, double speed, long size, double left, double right) {
        Recognition.Known known = recognition.know(id, size);
        known.motion().set(0, speed, 0);
        known.box().include(left, 0);
        known.box().include(right, HEIGHT);
    }

    private void know(int id, double speed) {
        know(id, speed, 2 * EVENTS, 0, WIDTH);
    }

    /** The structure of an upright edge, which comes from column 10 to 18 at 100 px/s, in 80 ms. */
    private int structureOfEdge() {
        List<Event> edge = Streams.edge(10, COLUMNS, ROWS, 0, 10_000);
        for (int i = 0; i < EVENTS; i++) {
            Event e = edge.get(i);
            numbers[i] = plane.events().head();
            plane.add(e.x(), e.y(), e.timeUs(), e.polarity());
        }
        PieceRefinement refinement =
            new PieceRefinement(new MetricFit(WIDTH, HEIGHT, MetricFit.CELL_PX, 4096, 300), P.search());
        refinement.begin(plane.events(), numbers, 0, EVENTS, 90, 0);
        while (!refinement.isOver()) {
            refinement.step();
        }
        return recognition.structureOf(numbers, 0, EVENTS, refinement);
    }

    @Test
    public void pieceIsAPartOfWhatMovesAlikeAroundIt() {
        know(3, 100);
        assertEquals(3, structureOfEdge());
    }

    @Test
    public void whatMovesOtherwiseIsNoPart() {
        // 2 px off at either end of the window
        know(3, 50);
        assertEquals(0, structureOfEdge());
    }

    @Test
    public void moreThanHalfOfAStructureIsNoPartOfIt() {
        know(3, 100, 2 * EVENTS - 1, 0, WIDTH);
        assertEquals(0, structureOfEdge());
    }

    @Test
    public void partLiesWithin4PxOfTheBoxAtItsLastEvent() {
        // the edge is in column 18 by then
        know(3, 100, 2 * EVENTS, 23, 60);
        assertEquals(0, structureOfEdge());
        know(4, 100, 2 * EVENTS, 21, 60);
        assertEquals(4, structureOfEdge());
    }

    @Test
    public void ofSeveralThePieceIsAPartOfTheOneAlongWhichItLosesLeast() {
        know(3, 97);
        know(4, 100);
        know(5, 103);
        assertEquals(4, structureOfEdge());
    }

    @Test
    public void onlyWhatWasToldOfLastIsKnown() {
        know(3, 100);
        recognition.look(0);
        assertEquals(0, structureOfEdge());
    }

    @Test
    public void eventsOfPartsAreShownOnceEachToTheirOwnStructure() {
        structureOfEdge();
        assertFalse(recognition.waits());
        for (int i = 0; i < EVENTS; i++) {
            recognition.give(1 + i % 3, numbers[i]);
        }
        assertTrue(recognition.waits());
        recognition.show(90_000);
        assertEquals(EVENTS, seenBy.size());
        for (int i = 0; i < EVENTS; i++) {
            assertEquals(1 + i % 3, (int) seenBy.get(i));
        }
        recognition.show(90_000);
        assertEquals(EVENTS, seenBy.size());
    }

    @Test
    public void pieceThatThereIsNoRoomForIsNoPart() {
        know(3, 100);
        structureOfEdge();
        for (int i = 0; i < (1 << 14) - EVENTS; i++) {
            recognition.give(3, numbers[i % EVENTS]);
        }
        assertEquals(3, structureOfEdge());
        recognition.give(3, numbers[0]);
        assertEquals(0, structureOfEdge());
    }
}
