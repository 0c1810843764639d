package io.github.sofas.flow.smooth;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;

/**
 * Which segments proved to be one. A segment that is another known again has the path of that one; pieces of a body
 * that merge later have one label, but paths of their own, because a piece's motion is that of the body only where the
 * piece is. Most segments have their own of both.
 */
final class Labels {
    private final Map<Integer, Integer> paths = new HashMap<>();
    private final Map<Integer, Integer> labels = new HashMap<>();
    /** Segments of the engine that were known again in another one, and live on as what is left of them. */
    private final Set<Integer> left = new HashSet<>();
    /** Those of them that are all of it again. */
    private final Set<Integer> resumed = new HashSet<>();
    /** Paths of pieces that merged into a body. */
    private final Set<Integer> merged = new HashSet<>();
    /** Segments that the engine ended. */
    private final Set<Integer> ended = new HashSet<>();
    /** The label that each goes on as that has ended. */
    private final Map<Integer, Integer> ends = new HashMap<>();
    /** Labels that events got for good. */
    private final Set<Integer> given = new HashSet<>();

    private static int in(Map<Integer, Integer> map, int id) {
        Integer other = map.get(id);
        return other == null ? id : other;
    }

    private static void join(Map<Integer, Integer> map, int from, int to) {
        if (from == to) {
            return;
        }
        map.replaceAll((id, other) -> other == from ? to : other);
        map.put(from, to);
    }

    /** The path of a segment of the engine. */
    int path(int segment) {
        return in(paths, segment);
    }

    /** The label of the events of a path. */
    int ofPath(int path) {
        return in(labels, path);
    }

    /** Gives all that have a label another one. */
    void join(int from, int to) {
        join(labels, from, to);
        ends.replaceAll((label, other) -> other == from ? to : other);
    }

    /** Ends a label, of which another is told to be what it became. */
    void end(int label, int into) {
        ends.put(label, into);
    }

    /** What a label that has ended became. */
    int endOf(int label) {
        return in(ends, label);
    }

    /**
     * Notes that a piece merged into a body; false where it merged before: what a piece was known again in may merge,
     * and what is left of the piece merge into another body, but these two are not one by that.
     */
    boolean mergeOnce(int path) {
        return merged.add(path);
    }

    /** Lets the path of a piece go that no event has any more. */
    void forgetPiece(int path) {
        labels.remove(path);
        merged.remove(path);
        ended.remove(path);
    }

    /** Gives all that have a path another one; their label stays. */
    void joinPaths(int from, int to) {
        leave(to);
        paths.forEach((segment, path) -> {
            if (path == to) {
                leave(segment);
            }
        });
        join(paths, from, to);
    }

    private void leave(int segment) {
        resumed.remove(segment);
        if (!ended.contains(segment)) {
            left.add(segment);
        }
    }

    /**
     * Notes that the engine ended a segment; false where it was what is left of one that was known again. What is left
     * of one that was known again in this is all of it from now on, the newest where there are several: it may get the
     * body's events again, and its motion would not be known.
     */
    boolean endSegment(int segment) {
        if (left.remove(segment)) {
            return false;
        }
        ended.add(segment);
        resumed.remove(segment);
        int newest = 0;
        for (int other : left) {
            if (path(other) == path(segment)) {
                newest = Math.max(newest, other);
            }
        }
        resume(newest);
        return true;
    }

    /** Whether a segment was known again in another one, which has its path now. */
    boolean isLeft(int segment) {
        return left.contains(segment);
    }

    /** Notes that what was left of a segment is all of it again; of one of which nothing is left, nothing. */
    void resume(int segment) {
        if (left.remove(segment)) {
            resumed.add(segment);
        }
    }

    /** Whether what was left of a segment is all of what has a path, and may get events on it. */
    boolean isResumed(int path) {
        for (int segment : resumed) {
            if (path(segment) == path) {
                return true;
            }
        }
        return false;
    }

    /** Notes that events got a label for good. */
    void give(int label) {
        given.add(label);
    }

    /** Whether events got a label for good. */
    boolean isGiven(int label) {
        return given.contains(label);
    }

    /** Lets a label go that no event gets any more. */
    void forget(int label) {
        ended.removeIf(segment -> ofPath(path(segment)) == label);
        resumed.removeIf(segment -> ofPath(path(segment)) == label);
        merged.removeIf(path -> ofPath(path) == label);
        paths.values().removeIf(path -> ofPath(path) == label);
        labels.values().removeIf(each -> each == label);
        ends.remove(label);
        given.remove(label);
    }
}
