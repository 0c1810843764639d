package io.github.sofas.flow;

import io.github.sofas.event.EventBatch;
import io.github.sofas.flow.smooth.Smoother;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;

/**
 * The segments as look-ahead reports them: under their labels, each with those of its events that were given back. The
 * end of a segment is reported once all of its events were given back.
 */
final class SmoothedSegments {
    private final Smoother smoother;
    private final Consumer<Segment> ended;
    /** Segments that the engine has measured and not yet ended. */
    private final Set<Integer> living = new TreeSet<>();
    /** The segment that ended last, by label; more events with that label may follow. */
    private final Map<Integer, Segment> ending = new LinkedHashMap<>();
    private final Map<Integer, Tally> tallies = new HashMap<>();

    /** The events of a segment that were given back. */
    private static final class Tally {
        private long firstUs = Long.MAX_VALUE;
        private long lastUs = Long.MIN_VALUE;
        private long events;

        void add(long timeUs) {
            firstUs = Math.min(firstUs, timeUs);
            lastUs = Math.max(lastUs, timeUs);
            events++;
        }

        void add(Tally other) {
            firstUs = Math.min(firstUs, other.firstUs);
            lastUs = Math.max(lastUs, other.lastUs);
            events += other.events;
        }

        Segment segment(Segment causal, int label, int mergedInto) {
            return new Segment(label, events == 0 ? causal.firstTimeUs() : firstUs,
                events == 0 ? causal.lastTimeUs() : lastUs, events, causal.vxPxPerS(), causal.vyPxPerS(),
                causal.turnRadPerS(), causal.growthPerS(), causal.minX(), causal.minY(), causal.maxX(), causal.maxY(),
                causal.fate(), mergedInto);
        }
    }

    /** Begins without segments; {@code ended} gets each segment that ended. */
    SmoothedSegments(Smoother smoother, Consumer<Segment> ended) {
        this.smoother = smoother;
        this.ended = ended;
    }

    /** Notes that the engine has measured a segment. */
    void begin(int segment) {
        living.add(segment);
    }

    /** Notes that the engine has ended a segment. */
    void end(Segment segment) {
        living.remove(segment.id());
        if (!smoother.end(segment.id())) {
            return;
        }
        int label = smoother.label(segment.id());
        if (segment.fate() != Segment.Fate.MERGED || smoother.merge(segment.id(), segment.mergedInto())) {
            ending.put(label, segment);
        }
    }

    /** Counts events that are given back, and reports the segments that are over by then. */
    void give(EventBatch batch, FlowOutput flow) {
        Tally tally = null;
        int tallied = 0;
        for (int i = 0; i < batch.size(); i++) {
            if (flow.segment[i] != 0) {
                if (flow.segment[i] != tallied) {
                    tallied = flow.segment[i];
                    tally = tallies.computeIfAbsent(tallied, id -> new Tally());
                }
                tally.add(batch.timeUs[i]);
            }
        }
        reportEnded();
    }

    private void reportEnded() {
        boolean isAnyOver = false;
        for (int label : List.copyOf(ending.keySet())) {
            if (wasJoined(label)) {
                ending.merge(smoother.label(label), ending.remove(label), SmoothedSegments::later);
            }
            isAnyOver |= smoother.isOver(smoother.label(label)) || smoother.isOver(label);
        }
        if (!isAnyOver) {
            return;
        }
        Set<Integer> alive = new HashSet<>();
        for (int segment : living) {
            if (!smoother.isLeft(segment)) {
                alive.add(smoother.label(segment));
            }
        }
        boolean isAnyReported;
        do {
            // a segment that waited for one just reported may be over now, too
            isAnyReported = reportEnded(alive);
        } while (isAnyReported);
    }

    private boolean reportEnded(Set<Integer> alive) {
        boolean isAnyReported = false;
        for (Map.Entry<Integer, Segment> next : List.copyOf(ending.entrySet())) {
            int label = next.getKey();
            Segment segment = next.getValue();
            boolean isMerged = segment.fate() == Segment.Fate.MERGED;
            if (smoother.isOver(label) && !alive.contains(label) && !awaitsMerged(label)) {
                isAnyReported = true;
                ending.remove(label);
                Tally own = tallies.containsKey(label) ? tallies.remove(label) : new Tally();
                Segment whole = own.segment(segment, label, isMerged ? smoother.endOf(label) : 0);
                if (isMerged) {
                    tallies.computeIfAbsent(whole.mergedInto(), id -> new Tally()).add(own);
                }
                ended.accept(whole);
                smoother.forget(label);
            }
        }
        return isAnyReported;
    }

    /** Whether another label that merged into this one may still have events, which count for this one. */
    private boolean awaitsMerged(int label) {
        for (int other : ending.keySet()) {
            // two labels that merged into each other, with a recognition in between, do not wait for each other
            if (other != label && mergedInto(other, label) && !mergedInto(label, other)) {
                return true;
            }
        }
        return false;
    }

    private boolean mergedInto(int label, int other) {
        return ending.get(label).fate() == Segment.Fate.MERGED && smoother.endOf(label) == other;
    }

    /** Whether the events of a label that has ended go under another label now. */
    private boolean wasJoined(int label) {
        return ending.get(label).fate() != Segment.Fate.MERGED && smoother.label(label) != label;
    }

    private static Segment later(Segment a, Segment b) {
        return a.lastTimeUs() >= b.lastTimeUs() ? a : b;
    }

    /** The segments that the engine tracks, as look-ahead knows them. */
    List<Segment> living(List<Segment> tracked) {
        Map<Integer, Segment> newest = new LinkedHashMap<>();
        for (Segment segment : tracked) {
            if (!smoother.isLeft(segment.id())) {
                newest.merge(smoother.label(segment.id()), segment, SmoothedSegments::later);
            }
        }
        List<Segment> segments = new ArrayList<>();
        newest.forEach((label, segment) ->
            segments.add(tallies.getOrDefault(label, new Tally()).segment(segment, label, 0)));
        return segments;
    }
}
