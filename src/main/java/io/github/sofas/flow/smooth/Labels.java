package io.github.sofas.flow.smooth;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;

/**
 * Records which segments of the engine proved to be one, by giving each segment a path and a label. Where a lost
 * segment is recognised in a new one, the new one gets the path of the lost one. Pieces of a body that merge later
 * share one label but keep their own paths, because the motion of a piece is that of the body only where the piece is.
 * Most segments have a path and a label of their own.
 */
final class Labels {
    private final Map<Integer, Integer> paths = new HashMap<>();
    private final Map<Integer, Integer> labels = new HashMap<>();
    /** Engine segments that were recognised in another one and still live: each is the remnant of a lost segment. */
    private final Set<Integer> left = new HashSet<>();
    /** Former remnants that are all of their segment again. */
    private final Set<Integer> resumed = new HashSet<>();
    /** Paths of pieces that merged into a body. */
    private final Set<Integer> merged = new HashSet<>();
    /** Segments that the engine ended. */
    private final Set<Integer> ended = new HashSet<>();
    /** For each label that has ended, the label that it continues as. */
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

    /** Gives another label to all that have a given one. */
    void join(int from, int to) {
        join(labels, from, to);
        ends.replaceAll((label, other) -> other == from ? to : other);
    }

    /** Ends a label, and notes the label that it is reported to have become. */
    void end(int label, int into) {
        ends.put(label, into);
    }

    /** The label that an ended label became. */
    int endOf(int label) {
        return in(ends, label);
    }

    /**
     * Notes that a piece merged into a body; false if it merged before. The segment in which a piece was recognised may
     * merge into one body, and the remnant of the piece into another: that does not make the two bodies one.
     */
    boolean mergeOnce(int path) {
        return merged.add(path);
    }

    /** Forgets the path of a piece that no event has any more. */
    void forgetPiece(int path) {
        labels.remove(path);
        merged.remove(path);
        ended.remove(path);
    }

    /** Gives another path to all that have a given one; their label stays. */
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
     * Notes that the engine ended a segment; false if the segment was the remnant of one recognised in another. If a
     * lost segment was recognised in the ended one, its remnant is all of it from now on; of several, the newest. The
     * remnant may get the body's events again, and its motion would not be known otherwise.
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

    /** Whether a segment was recognised in another one, which has its path now. */
    boolean isLeft(int segment) {
        return left.contains(segment);
    }

    /** Notes that the remnant of a segment is all of it again; does nothing if the segment has no remnant. */
    void resume(int segment) {
        if (left.remove(segment)) {
            resumed.add(segment);
        }
    }

    /** Whether a former remnant is all that has a path, and may get events on it. */
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

    /** Forgets a label that no event gets any more. */
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
