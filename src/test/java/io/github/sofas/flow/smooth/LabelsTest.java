package io.github.sofas.flow.smooth;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import org.junit.Test;

public class LabelsTest {
    private final Labels labels = new Labels();

    @Test
    public void mostHaveTheirOwnPathAndLabel() {
        assertEquals(7, labels.path(7));
        assertEquals(7, labels.ofPath(7));
    }

    @Test
    public void piecesOfPiecesGetTheLabelOfTheLast() {
        labels.join(1, 2);
        labels.join(2, 3);
        assertEquals(3, labels.ofPath(1));
        assertEquals(3, labels.ofPath(2));
        assertEquals("a piece has its own path", 1, labels.path(1));
    }

    @Test
    public void whatIsKnownAgainHasThePathAndLabelOfTheOneBefore() {
        labels.join(1, 2);
        labels.join(6, 5);
        labels.joinPaths(5, 1);
        labels.join(5, 2);
        assertEquals(1, labels.path(5));
        assertEquals(2, labels.ofPath(labels.path(5)));
        assertEquals("its pieces go with it", 2, labels.ofPath(6));
    }

    @Test
    public void whatIsLeftEndsUnseenUnlessItBecomesAllOfItAgain() {
        labels.joinPaths(7, 2);
        assertTrue(labels.isLeft(2));
        assertFalse("7 goes on as 2", labels.endSegment(2));
        labels.joinPaths(8, 3);
        labels.resume(3);
        assertFalse(labels.isLeft(3));
        assertTrue("8 became one with 3", labels.endSegment(3));
    }

    @Test
    public void whatIsLeftIsAllOfItOnceTheOneItWasKnownAgainInEnds() {
        labels.joinPaths(7, 2);
        labels.joinPaths(9, 2);
        labels.joinPaths(8, 3);
        assertTrue(labels.endSegment(9));
        assertFalse("the newest gets its events again", labels.isLeft(7));
        assertTrue(labels.isLeft(2));
        assertTrue("another's is left", labels.isLeft(3));
    }

    @Test
    public void whatIsAllOfItAgainMayGetEventsUntilItEnds() {
        labels.joinPaths(9, 2);
        assertFalse("9 is known", labels.isResumed(2));
        labels.endSegment(9);
        assertTrue(labels.isResumed(2));
        assertFalse(labels.isResumed(9));
        labels.endSegment(2);
        assertFalse(labels.isResumed(2));
        labels.joinPaths(8, 3);
        labels.endSegment(8);
        labels.forget(3);
        assertFalse("its label is over", labels.isResumed(3));
    }

    @Test
    public void whatIsLeftOnceMoreIsNotAllOfIt() {
        labels.joinPaths(9, 2);
        labels.endSegment(9);
        labels.joinPaths(11, 2);
        assertTrue(labels.isLeft(2));
        assertFalse("11 is", labels.isResumed(2));
        labels.endSegment(2);
        assertFalse("nothing is left", labels.isResumed(2));
    }

    @Test
    public void forgetsWhatIsOver() {
        labels.joinPaths(5, 1);
        labels.join(1, 2);
        labels.give(2);
        assertTrue(labels.isGiven(2));
        labels.forget(2);
        assertFalse(labels.isGiven(2));
        assertEquals(5, labels.path(5));
        assertEquals(1, labels.ofPath(1));
    }

    @Test
    public void piecesAreForgottenButNotWhatALabelBecame() {
        labels.end(1, 2);
        labels.join(1, 2);
        labels.join(2, 3);
        labels.forgetPiece(1);
        labels.forgetPiece(2);
        assertEquals("1 became 2, which became 3", 3, labels.endOf(1));
        assertEquals(2, labels.ofPath(2));
    }

    @Test
    public void pathIsAPieceOfOneBodyUntilItIsForgotten() {
        assertTrue(labels.mergeOnce(1));
        assertFalse(labels.mergeOnce(1));
        labels.forgetPiece(1);
        assertTrue(labels.mergeOnce(1));
        labels.join(1, 2);
        labels.forget(2);
        assertTrue("its label is over", labels.mergeOnce(1));
    }
}
