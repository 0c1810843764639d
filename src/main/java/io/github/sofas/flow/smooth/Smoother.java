package io.github.sofas.flow.smooth;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.flow.SofasParameters;
import io.github.sofas.flow.motion.Motion;
import io.github.sofas.flow.motion.NoiseRate;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * Labels events anew, from the events on both sides of them. Time is cut into slices, {@value #AHEAD} of which make up
 * the look-ahead. When a slice is complete, the one {@value #FIRST_LOOK} slices before it is labelled anew. With these
 * labels on both sides, the one {@value #AHEAD} slices before it is labelled once more, for good; its events get the
 * velocity of their segment's path.
 *
 * <p>A slice ends at a multiple of its duration in the time of the events, or early when it has {@value #MOST_EVENTS}
 * events. So results depend on the events only, and memory is bounded.
 */
public final class Smoother {
    /** Slices in the look-ahead. */
    public static final int AHEAD = 4;
    /** Most events of a slice. */
    public static final int MOST_EVENTS = 1 << 16;
    /** Slices after which events are labelled anew for the first time. */
    private static final int FIRST_LOOK = 2;
    /** Slices that are kept: as many before the one that is labelled for good as after it. */
    private static final int KEPT = 2 * AHEAD + 1;
    /**
     * Bytes per event for measured motions: one takes about a hundred bytes, and there is one for 25 events or more.
     */
    private static final int BYTES_PER_EVENT = 4;
    /** Blocks of a slice; over each, a motion is taken as steady. */
    private static final int BLOCKS = 32;
    /** Most blocks of all slices: those of a short slice are of whole microseconds. */
    private static final int MOST_BLOCKS = KEPT * 2 * BLOCKS;

    private final SensorSize sensor;
    private final long sliceUs;
    private final long blockUs;
    private final EventWindow window = new EventWindow();
    private final List<Slice> slices = new ArrayList<>();
    /** By rising id, so that the order does not depend on hashes. */
    private final Map<Integer, SegmentPath> paths = new TreeMap<>();
    private final NoiseRate noise;
    private final Competition competition;
    private final CentredFit fit;
    private final PathAlignment alignment;
    private final WarpLoss warpLoss;
    private final Tremor tremor;
    private final Labels labels = new Labels();
    private final KnownAgain knownAgain;
    private long sliceFrom;
    private long sliceFromUs = Long.MIN_VALUE;
    /** Number of the first event that is not labelled for good, and of the first that was not taken. */
    private long labelled;
    private long taken;
    private long newestUs = Long.MIN_VALUE;
    /** Whether no events follow. */
    private boolean finished;

    /**
     * Makes an empty one.
     *
     * @param p what motions may have
     * @param lookAheadUs in µs
     */
    public Smoother(SensorSize sensor, SofasParameters.Track p, long lookAheadUs) {
        this.sensor = sensor;
        sliceUs = SliceClock.sliceUs(lookAheadUs);
        noise = new NoiseRate(sensor);
        competition = new Competition(sensor, window, labels);
        fit = new CentredFit(sensor, window, p);
        alignment = new PathAlignment(sensor, window);
        warpLoss = new WarpLoss(sensor, window);
        blockUs = Math.max(1, sliceUs / BLOCKS);
        tremor = new Tremor(window, labels, blockUs, MOST_BLOCKS);
        knownAgain = new KnownAgain(sensor, window);
    }

    /**
     * Most bytes that it holds if events are taken as soon as they can be: those of its arrays, and
     * {@value #BYTES_PER_EVENT} per event for measured motions and what is known of segments.
     */
    public static long mostBytes(SensorSize sensor) {
        int mostEvents = (KEPT + 1) * MOST_EVENTS;
        return EventWindow.mostBytes(mostEvents) + (KEPT + 1) * Slice.mostBytes(sensor, MOST_EVENTS)
            + Competition.mostBytes(sensor, MOST_EVENTS) + CentredFit.bytes(sensor) + 2 * Picture.bytes(sensor)
            + PathAlignment.bytes(sensor) + WarpLoss.bytes(sensor) + NoiseRate.bytes(sensor)
            + Tremor.bytes(MOST_BLOCKS) + (long) BYTES_PER_EVENT * mostEvents;
    }

    private int events() {
        return (int) (window.end() - sliceFrom);
    }

    private long sliceUntilUs() {
        return SliceClock.untilUs(sliceFromUs, sliceUs);
    }

    /** Takes a measured motion of a segment. */
    public void add(int segment, Motion motion) {
        if (!labels.isLeft(segment)) {
            path(labels.path(segment)).add(motion);
        }
    }

    /** Whether a segment of the engine was recognised in another one, and is of no interest any more. */
    public boolean isLeft(int segment) {
        return labels.isLeft(segment);
    }

    /** Notes that the engine ended a segment; false if the segment was the remnant of one recognised in another. */
    public boolean end(int segment) {
        return labels.endSegment(segment);
    }

    /** The label of a segment's events: its own, or that of a segment that it proved to be the same as. */
    public int label(int segment) {
        return labels.ofPath(labels.path(segment));
    }

    /**
     * Notes that a segment proved to be a piece of another that lives on. Events of both that are not labelled for good
     * get one label: that of the other segment, or that of the piece if events were labelled for good with that one
     * only.
     *
     * @return whether the label of the piece ends with this: the piece is no part of the other label by its motion, or
     *     events were labelled for good with its own label, which no others get any more
     */
    public boolean merge(int segment, int into) {
        if (labels.path(segment) == labels.path(into)) {
            // a segment in which a lost one was recognised merges with the remnant of the lost one
            labels.resume(into);
            return false;
        }
        int from = label(segment);
        int to = label(into);
        SegmentPath piece = path(labels.path(segment));
        SegmentPath body = path(labels.path(into));
        if (!labels.isResumed(piece.id())) {
            piece.end();
        }
        if (from == to || !labels.mergeOnce(piece.id())) {
            return false;
        }
        if (piece.isMeasured() && body.isMeasured() && !piece.movedAsOneWith(body)) {
            labels.end(from, to);
            return true;
        }
        boolean goesOn = labels.isGiven(from) && !labels.isGiven(to);
        joinLabels(goesOn ? to : from, goesOn ? from : to);
        boolean ends = labels.isGiven(from) && !goesOn;
        if (ends) {
            labels.end(from, to);
        }
        return ends;
    }

    /** The label that a label ended by {@link #merge} continues as. */
    public int endOf(int label) {
        return labels.endOf(label);
    }

    private void joinLabels(int from, int to) {
        labels.join(from, to);
        window.replace(window.label, labelled, from, to);
        slices.forEach(Slice::outdate);
    }

    private SegmentPath path(int segment) {
        return paths.computeIfAbsent(segment, SegmentPath::new);
    }

    /** Takes an event with its causal label. */
    public void add(EventBatch batch, FlowOutput causal, int i) {
        newestUs = Math.max(newestUs, batch.timeUs[i]);
        if (sliceFromUs == Long.MIN_VALUE) {
            sliceFromUs = Math.floorDiv(newestUs, sliceUs) * sliceUs;
        }
        int id = labels.path(causal.segment[i]);
        if (id != 0) {
            path(id).see(newestUs);
        } else if (sensor.contains(batch.x[i], batch.y[i])) {
            noise.note(batch.x[i], batch.y[i], newestUs);
        }
        int k = window.add(newestUs, batch.timeUs[i], batch.x[i], batch.y[i], batch.polarity[i]);
        window.give(k, id, labels.ofPath(id));
        window.vxPxPerS[k] = causal.vxPxPerS[i];
        window.vyPxPerS[k] = causal.vyPxPerS[i];
    }

    /** Ends the slices that are over before an event of that time ({@link SliceClock}). */
    public void endSlices(long timeUs) {
        if (events() >= MOST_EVENTS) {
            endSlice(Math.min(sliceUntilUs(), newestUs + 1));
        }
        while (timeUs >= sliceUntilUs()) {
            endSlice(sliceUntilUs());
            if (labelled == window.end() && timeUs >= sliceUntilUs()) {
                // no event waits: skip to where events continue
                slices.clear();
                sliceFromUs = Math.floorDiv(timeUs, sliceUs) * sliceUs;
            }
        }
    }

    private void endSlice(long untilUs) {
        noise.goOn(untilUs);
        slices.add(new Slice(window, sensor, sliceFrom, sliceFromUs, Math.max(untilUs, sliceFromUs + 1),
            noise.perUs()));
        sliceFrom = window.end();
        sliceFromUs = untilUs;
        findLost();
        refine();
        look(FIRST_LOOK);
        look(AHEAD);
        int done = slices.size() - 1 - AHEAD;
        if (done >= 0) {
            Slice slice = slices.get(done);
            unlabel(slice);
            settle(slice);
            labelled = slice.until;
        }
        if (slices.size() == KEPT) {
            Slice oldest = slices.remove(0);
            window.forget(Math.min(oldest.until, taken));
            paths.values().removeIf(path -> {
                path.forget(oldest.untilUs);
                boolean isGone = path.newestUs() < oldest.untilUs;
                if (isGone && path.hasEnded()) {
                    labels.forgetPiece(path.id());
                }
                return isGone;
            });
        }
    }

    /** Looks for lost segments among those that began recently. */
    private void findLost() {
        for (SegmentPath begun : List.copyOf(paths.values())) {
            if (begun.isMeasured() && !begun.hasEnded() && !labels.isGiven(labels.ofPath(begun.id()))) {
                SegmentPath lost = knownAgain.find(begun, paths.values(), slices);
                if (lost != null) {
                    lost.takeOver(begun);
                    int label = labels.ofPath(begun.id());
                    labels.joinPaths(begun.id(), lost.id());
                    joinLabels(label, labels.ofPath(lost.id()));
                    paths.remove(begun.id());
                    slices.forEach(slice -> slice.join(begun.id(), lost.id()));
                    window.replace(window.segment, 0, begun.id(), lost.id());
                }
            }
        }
    }

    /** In the slice that is labelled next, measures paths that turn or grow anew, and bends all paths. */
    private void refine() {
        int index = slices.size() - 1 - FIRST_LOOK;
        if (index < 0) {
            return;
        }
        Slice slice = slices.get(index);
        for (SegmentPath path : paths.values()) {
            if (path.isMeasured() && slice.has(path.id())) {
                path.refine(slice, FIRST_LOOK * sliceUs,
                    (us, sideUs, least) -> fit.measure(path, slices, us, sideUs, least));
                alignment.bend(path, slices, slice, sliceUs);
            }
        }
    }

    private void look(int back) {
        int index = slices.size() - 1 - back;
        if (index < 0) {
            return;
        }
        Slice slice = slices.get(index);
        slice.refresh(window);
        List<SegmentPath> near = new ArrayList<>();
        for (SegmentPath path : paths.values()) {
            if (path.isMeasured() && path.newestUs() >= slice.fromUs - back * sliceUs
                    && slice.fromUs < path.endUs()) {
                near.add(path);
            }
        }
        competition.decide(slices, index, near, AHEAD * sliceUs, finished);
        slice.relabel();
    }

    /** Takes away labels that would blur the picture. */
    private void unlabel(Slice slice) {
        for (int id : slice.bySegment(window).segments()) {
            SegmentPath path = paths.get(id);
            if (path != null && path.isMeasured()) {
                warpLoss.unlabel(path, slices, slice, AHEAD * sliceUs);
            }
        }
        slice.relabel();
    }

    private void settle(Slice slice) {
        tremor.look(paths.get(slice.largest()), slices, slice);
        SegmentEvents events = slice.bySegment(window);
        for (int id : events.segments()) {
            SegmentPath path = paths.get(id);
            int label = labels.ofPath(id);
            labels.give(label);
            if (path != null && path.isMeasured()) {
                int until = events.until(id);
                for (int each = events.from(id); each < until; each++) {
                    int k = window.at(events.event(each));
                    Motion motion = path.about(window.timeUs[k], blockUs);
                    float pace = tremor.factor(label, window.timeUs[k]);
                    window.vxPxPerS[k] = pace * motion.vxAt(window.x[k], window.y[k], window.timeUs[k]);
                    window.vyPxPerS[k] = pace * motion.vyAt(window.x[k], window.y[k], window.timeUs[k]);
                }
            }
        }
    }

    /** Labels all events for good. */
    public void finish() {
        finished = true;
        while (labelled < window.end()) {
            endSlice(sliceUntilUs());
        }
    }

    /**
     * Whether a label is over: no event gets it unless the engine finds more of its segment, and all events that have
     * it were taken.
     */
    public boolean isOver(int label) {
        boolean isOver = taken == labelled;
        for (int path : paths.keySet()) {
            isOver &= finished || labels.ofPath(path) != label;
        }
        return isOver;
    }

    /** Forgets a label that no event gets any more. */
    public void forget(int label) {
        labels.forget(label);
    }

    /**
     * Clears a batch, and fills it with the next events that were labelled for good.
     *
     * @return whether there were any
     */
    public boolean take(EventBatch batch, FlowOutput flow) {
        batch.clear();
        int most = Math.min(batch.capacity(), flow.capacity());
        while (taken < labelled && batch.size() < most) {
            int k = window.at(taken++);
            int i = batch.size();
            batch.add(window.givenUs[k], window.x[k], window.y[k], window.polarity[k]);
            boolean moves = window.label[k] != 0;
            flow.segment[i] = window.label[k];
            flow.vxPxPerS[i] = moves ? window.vxPxPerS[k] : 0;
            flow.vyPxPerS[i] = moves ? window.vyPxPerS[k] : 0;
        }
        return batch.size() > 0;
    }
}
