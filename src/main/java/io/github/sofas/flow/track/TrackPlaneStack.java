package io.github.sofas.flow.track;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.flow.PixelConsumer;
import io.github.sofas.flow.Segment;
import io.github.sofas.flow.SofasParameters;
import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.motion.MeasuredMotions;
import io.github.sofas.flow.motion.NoiseRate;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Consumer;

/**
 * The structures that are tracked (paper, section Algorithm). Each event is labelled by the track plane that it belongs
 * to ({@link #label}). From time to time, track planes end, part and merge ({@link #check}).
 *
 * <p>Ours: an event is not offered to the planes in turn, but goes to the best of the {@link Candidates}. In turn, the
 * older of two crossing structures would take the events of the other.
 */
public final class TrackPlaneStack {
    /** Most events that the motion of a track plane is measured from. */
    public static final int MOST_MEASURED = Measurement.MOST_EVENTS;

    private static final long CHECK_US = 5_000;
    /** Gap between the boxes of two structures, in px, within which one may hide a part of the other. */
    private static final double HIDDEN_PX = 4;

    private final Consumer<Segment> ended;
    private SofasParameters.Track p;
    private final MetricFit fit;
    private TrackPlane[] planes;
    private final List<TrackPlane> unused = new ArrayList<>();
    private final FoundPlanes found;
    private LiveEvents spare = new LiveEvents();
    private final Merging merging = new Merging();
    private final Parting parting;
    private final TakenOver taken;
    /** A plane for the next part: until planes are adopted, the unused ones may be in use by another thread. */
    private TrackPlane forPart;
    private final Doubts doubts;
    private final SettledTiles settled;
    private final PixelHistory history;
    private final Bursts bursts;
    private final NoiseRate noise;
    private final Candidates candidates;
    private final Reaches reaches = new Reaches();
    private int size;
    private int nextId = 1;
    private long nextCheckUs = Long.MIN_VALUE;

    /**
     * Makes an empty stack that reports segments when they end, and their motions when they are measured.
     *
     * @param foundFit for the planes that are found, whose motions another thread may measure
     */
    public TrackPlaneStack(SensorSize sensor, SofasParameters.Track p, MetricFit fit, MetricFit foundFit,
                           Consumer<Segment> ended, MeasuredMotions measured) {
        this.p = p;
        this.fit = fit;
        this.ended = ended;
        found = new FoundPlanes(sensor, p, foundFit, measured);
        TiledEvents tiled = new TiledEvents(sensor);
        parting = new Parting(sensor, tiled);
        taken = new TakenOver(tiled);
        doubts = new Doubts(sensor);
        settled = new SettledTiles(sensor);
        history = new PixelHistory(sensor);
        candidates = new Candidates(history);
        bursts = new Bursts(sensor);
        noise = new NoiseRate(sensor);
        planes = new TrackPlane[p.maxTrackPlanes()];
        found.open(planes.length, unused, noise.perUs());
    }

    /** The most bytes that the arrays of the stack and its track planes take, except those of its fits. */
    public static long mostBytes(SensorSize sensor, SofasParameters.Track p) {
        // one more plane, for a part; one more ring, for merging; and bursts of both found and tracked planes
        return (p.maxTrackPlanes() + 1) * TrackPlane.mostBytes(sensor) + LiveEvents.BYTES + Contour.bytes(sensor)
            + TiledEvents.bytes(sensor) + Parting.bytes(sensor) + TakenOver.bytes(sensor) + Doubts.bytes(sensor)
            + SettledTiles.bytes(sensor) + PixelHistory.bytes(sensor) + 2 * Bursts.bytes(sensor)
            + NoiseRate.bytes(sensor);
    }

    /**
     * Gives an event to the plane that it belongs to. Labels the event with the motion that the plane had before,
     * unless that motion is found not to predict the events of the plane.
     *
     * @param output takes flow and segment as its entry i; none where no motion predicts the event
     * @return whether the event is explained; if not, it may belong to a structure that is not tracked yet
     */
    public boolean label(int x, int y, long timeUs, int polarity, FlowOutput output, int i) {
        if (!reaches.areKnownAt(timeUs)) {
            reaches.take(planes, size, timeUs, timeUs + CHECK_US);
        }
        if (!isLoneWall()) {
            return ask(x, y, timeUs, polarity, output, i);
        }
        TrackPlane wall = planes[0];
        if (settled.isSettled(x, y) && reaches.hold(0, Reaches.event(x, y))
                && wall.takesUnasked(x, y, timeUs, polarity)) {
            write(output, i, wall, x, y, timeUs);
            reaches.follow(wall, planes, size, timeUs);
            return true;
        }
        boolean isExplained = ask(x, y, timeUs, polarity, output, i);
        settled.note(x, y, isExplained);
        return isExplained;
    }

    /** Labels an event by the plane that it is found to belong to; returns whether there is one without doubt. */
    private boolean ask(int x, int y, long timeUs, int polarity, FlowOutput output, int i) {
        candidates.begin(x, y, timeUs, polarity);
        long event = Reaches.event(x, y);
        for (int k = 0; k < size; k++) {
            if (reaches.hold(k, event)) {
                candidates.offer(planes[k]);
            }
        }
        TrackPlane best = candidates.best();
        boolean isExpected = best != null;
        if (!isExpected) {
            best = remembering(x, y, timeUs);
            if (keepsHistory()) {
                best = candidates.unexpected(best, noise.perUs());
            } else if (isLoneWall()) {
                best = candidates.unexpectedAlone(best);
            }
        }
        boolean isDoubtful;
        Claim claim;
        if (candidates.isAppearing()) {
            claim = Claim.APPEARING;
            isDoubtful = false;
        } else if (!isExpected) {
            claim = Claim.REMEMBERED;
            // a structure that turns back comes to where its contour was
            isDoubtful = best != null && !best.isBent(x, y, timeUs);
        } else {
            isDoubtful = isLoneWall() ? candidates.isDoubtfulAlone() : candidates.isDoubtful();
            boolean isShared = candidates.areClose() || candidates.isWeak() && isRememberedByOther(best, x, y, timeUs);
            claim = isShared ? Claim.SHARED : Claim.OWN;
        }
        if (keepsHistory()) {
            history.note(x, y, timeUs, polarity);
        }
        if (best == null) {
            noise.note(x, y, timeUs);
            write(output, i, 0, 0, 0);
            return false;
        }
        if (best.isPredictive()) {
            write(output, i, best, x, y, timeUs);
        } else {
            write(output, i, 0, 0, 0);
        }
        best.take(x, y, timeUs, polarity, claim, bursts, fit);
        reaches.follow(best, planes, size, timeUs);
        return !(doubts.note(x, y, isDoubtful) && isDoubtful);
    }

    /**
     * Whether traces are known. For a lone wall they would cost a third of its labels, and no other structure is there.
     */
    private boolean keepsHistory() {
        return size > 1;
    }

    /** Whether a dense structure, such as a wall that fills the picture, is all that is tracked. */
    private boolean isLoneWall() {
        return size == 1 && planes[0].isDense();
    }

    /** Writes flow and segment of an event of a plane. */
    private static void write(FlowOutput output, int i, TrackPlane its, int x, int y, long timeUs) {
        float pace = (float) its.pace();
        write(output, i, its.id(), pace * its.motion().vxAt(x, y, timeUs), pace * its.motion().vyAt(x, y, timeUs));
    }

    private static void write(FlowOutput output, int i, int id, float vx, float vy) {
        output.segment[i] = id;
        output.vxPxPerS[i] = vx;
        output.vyPxPerS[i] = vy;
    }

    /**
     * The plane whose contour was at the place of an event that lies on no contour now. Of several planes, it is the
     * one that remembers most in relation to its lifetime.
     */
    private TrackPlane remembering(int x, int y, long timeUs) {
        TrackPlane best = null;
        double bestRate = 0;
        for (int i = 0; i < size; i++) {
            double rate = (double) planes[i].memory().remembered(x, y, timeUs) / planes[i].lifetimeUs();
            if (rate > bestRate) {
                best = planes[i];
                bestRate = rate;
            }
        }
        return best;
    }

    private boolean isRememberedByOther(TrackPlane plane, int x, int y, long timeUs) {
        for (int i = 0; i < size; i++) {
            if (planes[i] != plane && planes[i].memory().remembered(x, y, timeUs) > 0) {
                return true;
            }
        }
        return false;
    }

    /**
     * From time to time, removes planes whose structures are gone, lets other planes take over what is theirs, parts
     * planes that hold two bodies, and merges planes that describe one structure.
     */
    public void check(long nowUs) {
        if (nowUs < nextCheckUs) {
            return;
        }
        nextCheckUs = nowUs + CHECK_US;
        noise.goOn(nowUs);
        settled.follow(isLoneWall() ? planes[0].id() : 0);
        reaches.forget();
        for (int i = size - 1; i >= 0; i--) {
            planes[i].correctSpeed(isHidden(i, nowUs), fit, nowUs);
            if (planes[i].update(nowUs, noise.perUs()) == Life.State.ENDED) {
                end(i, Segment.Fate.REMOVED, 0);
            } else {
                planes[i].measureIfLate(fit, nowUs);
            }
        }
        for (int i = size - 1; i >= 0; i--) {
            if (planes[i].beginsToPart(nowUs) && !isTakenOver(i, nowUs) && forPart != null && size < planes.length
                    && planes[i].findPart(parting, fit)) {
                planes[i].giveUp(parting, forPart, fit, nowUs);
                add(forPart);
                forPart = null;
            }
        }
        for (int i = 0; i < size; i++) {
            for (int j = size - 1; j > i; j--) {
                if (merging.areOne(planes[i], planes[j], fit, nowUs)) {
                    merge(i, j, nowUs);
                }
            }
        }
    }

    /** Whether other structures lie where they may hide a part of a plane's structure. */
    private boolean isHidden(int i, long nowUs) {
        for (int j = 0; j < size; j++) {
            if (areNear(i, j, nowUs)) {
                return true;
            }
        }
        return false;
    }

    private boolean areNear(int i, int j, long nowUs) {
        return j != i && planes[i].contour().isWithin(HIDDEN_PX, planes[j].contour(), nowUs);
    }

    /** Whether a plane is made of parts of the planes around it. If so, they take it over, and it ends. */
    private boolean isTakenOver(int i, long nowUs) {
        TrackPlane plane = planes[i];
        if (!plane.offerTo(taken)) {
            return false;
        }
        for (int j = 0; j < size; j++) {
            if (areNear(i, j, nowUs) && planes[j].mayTakeOver(nowUs)) {
                taken.offer(planes[j].motion(), j);
            }
        }
        if (!taken.isExplained()) {
            return false;
        }
        TrackPlane heir = planes[taken.heir()];
        if (plane.isBent() && heir.id() > plane.id()) {
            // a structure that turned back keeps its number where a younger plane found its new motion first
            return false;
        }
        takeOver(plane.live(), nowUs);
        end(i, Segment.Fate.MERGED, heir.id());
        return true;
    }

    /** Gives the events of a plane to the planes that explain them. */
    private void takeOver(LiveEvents live, long nowUs) {
        for (int k = 0; k < taken.size(); k++) {
            int event = taken.index(k);
            planes[taken.owner(k)].see(live.x[event], live.y[event], live.timeUs[event], live.sign[event], nowUs);
        }
    }

    private void add(TrackPlane plane) {
        planes[size++] = plane;
        plane.number(nextId++);
    }

    /** The older of two planes takes over the younger; both move along the common motion. */
    private void merge(int i, int j, long nowUs) {
        if (planes[i].id() > planes[j].id()) {
            TrackPlane older = planes[j];
            planes[j] = planes[i];
            planes[i] = older;
        }
        spare = planes[i].merge(planes[j], merging.motion(), merging.bond(), spare, nowUs);
        end(j, Segment.Fate.MERGED, planes[i].id());
    }

    private void end(int i, Segment.Fate fate, int mergedInto) {
        ended.accept(planes[i].segment(fate, mergedInto));
        release(i);
    }

    private void release(int i) {
        planes[i].clear();
        unused.add(planes[i]);
        size--;
        planes[i] = planes[size];
        planes[size] = null;
        reaches.forget();
    }

    /** The planes that were found and are not in the stack yet. */
    public FoundPlanes found() {
        return found;
    }

    /** Whether a plane is one of the tracked planes. */
    public boolean tracks(TrackPlane plane) {
        for (int i = 0; i < size; i++) {
            if (planes[i] == plane) {
                return true;
            }
        }
        return false;
    }

    /** Number of tracked planes. */
    public int size() {
        return size;
    }

    /** One of the tracked planes, in no particular order. */
    public TrackPlane plane(int i) {
        return planes[i];
    }

    /** The plane that is tracked under a number; null if there is none. */
    public TrackPlane planeOf(int id) {
        for (int i = 0; i < size; i++) {
            if (planes[i].id() == id) {
                return planes[i];
            }
        }
        return null;
    }

    /**
     * Tracks the planes that were found. From then on as many may be found as there is room for. If parts of other
     * planes took that room meanwhile, the planes that were found last are dropped.
     */
    public void adopt() {
        if (found.size() > 0) {
            reaches.forget();
        }
        for (int i = 0; i < found.size(); i++) {
            if (size < planes.length) {
                add(found.plane(i));
            } else {
                found.plane(i).clear();
                unused.add(found.plane(i));
            }
        }
        found.open(planes.length - size, unused, noise.perUs());
        if (forPart == null && size > 0) {
            forPart = found.take();
        }
    }

    /** Notes a past event on the contour of a tracked plane, as a place where more events are expected. */
    public void see(TrackPlane plane, int x, int y, long timeUs, int polarity, long nowUs) {
        plane.see(x, y, timeUs, polarity, nowUs);
        reaches.follow(plane, planes, size, nowUs);
    }

    /** Votes that measurements have given since the start, a measure of work. */
    public long votes() {
        return fit.votes() + found.votes();
    }

    /** The living segments. */
    public List<Segment> segments() {
        List<Segment> segments = new ArrayList<>();
        for (int i = 0; i < size; i++) {
            segments.add(planes[i].segment(Segment.Fate.ALIVE, 0));
        }
        return segments;
    }

    /** Continues with other parameters. If fewer planes are allowed, the last ones end. */
    public void setParameters(SofasParameters.Track next) {
        adopt();
        p = next;
        while (size > p.maxTrackPlanes()) {
            end(size - 1, Segment.Fate.REMOVED, 0);
        }
        planes = Arrays.copyOf(planes, p.maxTrackPlanes());
        for (int i = 0; i < size; i++) {
            planes[i].setParameters(p);
        }
        unused.clear();
        forPart = null;
        found.setParameters(p);
        found.open(planes.length - size, unused, noise.perUs());
    }

    /** Shows the pixels of a living segment's contour that are on the sensor; none for any other id. */
    public void contour(int id, long nowUs, PixelConsumer pixels) {
        TrackPlane plane = planeOf(id);
        if (plane != null) {
            plane.contour().show(nowUs, pixels);
        }
    }

    /** Ends all segments, and restarts their numbers. */
    public void reset() {
        while (size > 0) {
            end(size - 1, Segment.Fate.REMOVED, 0);
        }
        noise.reset();
        found.reset();
        found.open(planes.length, unused, noise.perUs());
        doubts.reset();
        settled.follow(0);
        history.clear();
        bursts.reset();
        nextId = 1;
        nextCheckUs = Long.MIN_VALUE;
    }
}
