package io.github.sofas.flow.smooth;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.motion.Bounds;
import io.github.sofas.flow.motion.Motion;
import io.github.sofas.flow.motion.PixelBox;
import java.util.Arrays;
import java.util.List;

/**
 * Decides to which segment each open event of a slice belongs: the one along whose motion its edge came and went. The
 * travel on either side of an event has {@value #SIDE_PARTS} parts. A segment's claim is the number of parts with an
 * event of the same polarity within a pixel of where the motion puts the edge; an event on that very pixel counts more.
 * Nothing can be seen before a recording began and after it ended. A claim there counts for as much as the rest of the
 * travel would add, as long as a few px of travel show. An event that no segment claims is noise.
 *
 * <p>This class is longer than others, because three questions use the same tables of the slice, which are filled once:
 * which events are open, which segments may claim them, and how a claim is counted.
 */
final class Competition {
    /** Travel on either side of an event that is looked at, in px, and the number of its parts. */
    static final double TRACE_PX = 11;
    static final int SIDE_PARTS = 8;
    /** Parts of the travel whose events are decided at once, along one motion. */
    private static final double BLOCK_PARTS = 4;
    /** Least claim by which an event without a segment goes to one. */
    private static final double LEAST = 7;
    /** The same for an event that the engine gave to a segment. */
    private static final double LEAST_LABELLED = 5.4;
    /**
     * Standard deviations by which a claim must exceed that of noise, where this asks for more; and the same for the
     * claim of the segment that the engine gave the event to.
     */
    private static final double NOISE_SIGMAS = 4;
    private static final double LABELLED_SIGMAS = 2.5;
    /** Greater than any claim. */
    private static final double MOST = 8 * SIDE_PARTS;
    /** Added to the claim of the segment that has the event already. */
    private static final double PRIOR = 2.7;
    /** Weights, in a claim, of events without a label, and of events with the label of another segment. */
    private static final double NOBODYS = 0.7;
    private static final double OTHERS = 0.45;
    /** How many times denser events of other segments are on their edges, where they are met, than in the whole box. */
    private static final double DENSER = 3;
    /** Greatest factor by which a claim is raised where the recording does not cover all of the travel. */
    private static final double MOST_RAISED = 2.75;
    /** Travel during the look-ahead below which a segment's past and future do not show, in px. */
    private static final double LEAST_TRAVEL_PX = 2;
    /** Room around the places that are asked for, in px, in which events may be met there. */
    private static final int BESIDE_PX = 2;
    /** Margin around a segment's box in px. */
    private static final int MARGIN_PX = 8;
    /** Steps of the projection per part. */
    private static final int STEPS = 4;
    private static final int MOST_STEPS = (TraceMap.PARTS + 1) * STEPS;

    private static final int OPEN = 0;
    private static final int DECIDED = -1;

    private final EventWindow window;
    private final Labels labels;
    private final TraceMap map;
    private final PathProjection projection = new PathProjection();
    /** The box as it lies on the sensor during a slice. */
    private final Bounds onSensor = new Bounds();
    private final Motion motion = new Motion();
    // per event of the slice
    private double[] claim = new double[1024];
    private int[] winner = new int[1024];
    /**
     * Times of the first and the last event of the recording; the least and the greatest long where they are not known.
     */
    private long beginUs;
    private long endUs;
    /** The label of the segment that is claiming. */
    private int ownLabel;
    // of the present block
    private long fromUs;
    /** The parts of the block's time that the recording covers, as bits. */
    private long recorded;
    /** Events of other segments that are there, and the weight of such an event in a claim. */
    private int others;
    private double othersWeight;
    /** Claims that noise seldom reaches there; the second one for the segment that the engine gave an event to. */
    private double least;
    private double leastLabelled;
    private double left;
    private double top;
    private double right;
    private double bottom;

    Competition(SensorSize sensor, EventWindow window, Labels labels) {
        this.window = window;
        this.labels = labels;
        map = new TraceMap(sensor);
    }

    /** Most bytes that its arrays take if a slice has so many events. */
    static long mostBytes(SensorSize sensor, int mostEvents) {
        return TraceMap.bytes(sensor) + 2L * mostEvents * (Double.BYTES + Integer.BYTES);
    }

    /**
     * Labels the open events of a slice anew.
     *
     * @param slices the slices around it, in order
     * @param index of the slice among them
     * @param paths of the segments that may have events in the slice
     * @param sideUs most time that is looked at on either side
     * @param isComplete whether no events follow those of the slices
     */
    void decide(List<Slice> slices, int index, Iterable<SegmentPath> paths, long sideUs, boolean isComplete) {
        Slice slice = slices.get(index);
        beginUs = slices.get(0).from == 0 ? window.timeUs[window.at(0)] : Long.MIN_VALUE;
        endUs = isComplete ? window.timeUs[window.at(window.end() - 1)] : Long.MAX_VALUE;
        for (SegmentPath path : paths) {
            if ((!slice.has(path.id()) || path.isFirstSeenIn(slice)) && findBox(path, slices, index)) {
                slice.open(tile(left, slice.columns()), tile(top, slice.rows()), tile(right, slice.columns()),
                    tile(bottom, slice.rows()));
            }
        }
        if (!open(slice)) {
            return;
        }
        for (SegmentPath path : paths) {
            claim(path, slices, index, sideUs);
        }
        int n = (int) (slice.until - slice.from);
        int last = OPEN;
        int label = 0;
        for (int i = 0; i < n; i++) {
            if (winner[i] != DECIDED) {
                if (winner[i] != last) {
                    last = winner[i];
                    label = last == OPEN ? 0 : labels.ofPath(last);
                }
                window.give(window.at(slice.from + i), last, label);
            }
        }
    }

    private boolean open(Slice slice) {
        int n = (int) (slice.until - slice.from);
        if (claim.length < n) {
            claim = new double[2 * n];
            winner = new int[2 * n];
        }
        Arrays.fill(winner, 0, n, DECIDED);
        boolean any = false;
        for (int t = 0; t < slice.columns() * slice.rows(); t++) {
            if (slice.isOpen(t)) {
                any = true;
                for (int k = slice.start(t); k < slice.start(t + 1); k++) {
                    int i = (int) (slice.event(k) - slice.from);
                    winner[i] = OPEN;
                    claim[i] = window.segment[window.at(slice.event(k))] == 0 ? LEAST : LEAST_LABELLED;
                }
            }
        }
        return any;
    }

    private void claim(SegmentPath path, List<Slice> slices, int index, long mostSideUs) {
        Slice slice = slices.get(index);
        if (!findBox(path, slices, index) || !hasOpen(slice)) {
            return;
        }
        ownLabel = labels.ofPath(path.id());
        path.at(slice.middleUs(), motion);
        double speed = motion.speed(Math.hypot(right - left, bottom - top) / 4);
        long sideUs = (long) Math.min(TRACE_PX / Math.max(speed, 1e-3) * 1e6, mostSideUs);
        boolean shows = speed * sideUs * 1e-6 >= LEAST_TRAVEL_PX;
        long partUs = Math.max(1, sideUs / SIDE_PARTS);
        int blocks = (int) Math.ceil((slice.untilUs - slice.fromUs) / (BLOCK_PARTS * partUs));
        long blockUs = (slice.untilUs - slice.fromUs + blocks - 1) / blocks;
        for (long a = slice.fromUs; a < slice.untilUs; a += blockUs) {
            claimBlock(path, slices, index, a, Math.min(slice.untilUs, a + blockUs), sideUs, partUs, shows);
        }
    }

    /**
     * Finds the box where the segment may be during the slice: its box in the nearest slice with events of it, moved
     * along.
     */
    private boolean findBox(SegmentPath path, List<Slice> slices, int index) {
        PixelBox box = null;
        Slice nearest = null;
        for (int d = 0; d < slices.size() && box == null; d++) {
            for (int k = index - d; k <= index + d && box == null; k += Math.max(1, 2 * d)) {
                if (k >= 0 && k < slices.size()) {
                    nearest = slices.get(k);
                    box = nearest.box(path.id());
                }
            }
        }
        if (box == null) {
            return false;
        }
        Slice slice = slices.get(index);
        path.at(nearest.middleUs(), motion);
        double seconds = (slice.fromUs + slice.untilUs - nearest.fromUs - nearest.untilUs) * 0.5e-6;
        double dx = motion.vx * seconds;
        double dy = motion.vy * seconds;
        left = box.left + dx - MARGIN_PX;
        right = box.right + dx + MARGIN_PX;
        top = box.top + dy - MARGIN_PX;
        bottom = box.bottom + dy + MARGIN_PX;
        return true;
    }

    /** Narrows the box to its open tiles; false if it has none. */
    private boolean hasOpen(Slice slice) {
        int firstColumn = tile(left, slice.columns());
        int lastColumn = tile(right, slice.columns());
        int firstRow = tile(top, slice.rows());
        int lastRow = tile(bottom, slice.rows());
        int l = Integer.MAX_VALUE;
        int r = Integer.MIN_VALUE;
        int t = Integer.MAX_VALUE;
        int b = Integer.MIN_VALUE;
        for (int row = firstRow; row <= lastRow; row++) {
            for (int column = firstColumn; column <= lastColumn; column++) {
                if (slice.isOpen(row * slice.columns() + column)) {
                    l = Math.min(l, column);
                    r = Math.max(r, column);
                    t = Math.min(t, row);
                    b = Math.max(b, row);
                }
            }
        }
        if (l > r) {
            return false;
        }
        left = Math.max(left, (l << Slice.TILE_BITS) - 1);
        right = Math.min(right, r + 1 << Slice.TILE_BITS);
        top = Math.max(top, (t << Slice.TILE_BITS) - 1);
        bottom = Math.min(bottom, b + 1 << Slice.TILE_BITS);
        return left < right && top < bottom;
    }

    private static int tile(double place, int count) {
        return Math.max(0, Math.min(count - 1, (int) Math.floor(place) >> Slice.TILE_BITS));
    }

    private void claimBlock(SegmentPath path, List<Slice> slices, int index, long a, long b, long sideUs, long partUs,
                            boolean shows) {
        fromUs = a - sideUs;
        projection.begin(path, (a + b) / 2, fromUs, (double) STEPS / partUs, MOST_STEPS);
        recorded = TraceMap.parts(part(beginUs), part(endUs) + 1);
        map.clear();
        others = 0;
        for (int k = index; k >= 0 && slices.get(k).untilUs > fromUs; k--) {
            add(slices.get(k), slices.get(index), b + sideUs);
        }
        for (int k = index + 1; k < slices.size() && slices.get(k).fromUs < b + sideUs; k++) {
            add(slices.get(k), slices.get(index), b + sideUs);
        }
        othersWeight = othersWeight();
        double noise = slices.get(index).noisePerUs * partUs;
        least = NOBODYS * TraceMap.byNoise(noise, 2 * SIDE_PARTS, NOISE_SIGMAS);
        leastLabelled = PRIOR + NOBODYS * TraceMap.byNoise(noise, 2 * SIDE_PARTS, LABELLED_SIGMAS);
        ask(path, slices.get(index), a, b, shows);
    }

    /**
     * Weight of an event of another segment: the less, the more probably one is there in a part by chance, whatever the
     * motion. Where others are dense, an event shows little, above all to what is slow, whose parts last long.
     */
    private double othersWeight() {
        double pixels = (right - left + 2 * BESIDE_PX) * (bottom - top + 2 * BESIDE_PX);
        double expected = others / (2 * pixels * Math.max(1, Long.bitCount(recorded)));
        return OTHERS * (1 - TraceMap.chance(DENSER * expected));
    }

    /** Part of the block's time that contains a time, or the nearest part. */
    private int part(long us) {
        long lastUs = fromUs + projection.lastUs();
        return projection.step(Math.max(fromUs, Math.min(us, lastUs)) - fromUs) / STEPS;
    }

    /**
     * Adds to the map the events of a slice that fall in the box and may meet open events of the slice that is decided.
     */
    private void add(Slice slice, Slice asked, long untilUs) {
        int first = projection.step(Math.max(0, slice.fromUs - fromUs));
        int last = projection.step(Math.min(untilUs, slice.untilUs) - fromUs);
        onSensor.clear();
        for (int step = first; step <= last; step += Math.max(1, last - first)) {
            projection.goTo(step);
            for (int corner = 0; corner < 4; corner++) {
                double x = (corner & 1) == 0 ? left : right;
                double y = (corner & 2) == 0 ? top : bottom;
                onSensor.include(projection.backX(x, y), projection.backY(x, y));
            }
        }
        if (onSensor.right() < 0 || onSensor.bottom() < 0 || onSensor.left() >= slice.columns() << Slice.TILE_BITS
                || onSensor.top() >= slice.rows() << Slice.TILE_BITS) {
            return;
        }
        int lastRow = tile(onSensor.bottom(), slice.rows());
        int firstColumn = tile(onSensor.left(), slice.columns());
        int lastColumn = tile(onSensor.right(), slice.columns());
        for (int row = tile(onSensor.top(), slice.rows()); row <= lastRow; row++) {
            for (int column = firstColumn; column <= lastColumn; column++) {
                int tile = row * slice.columns() + column;
                if (asked.isNearOpen(tile)) {
                    addTile(slice, tile, untilUs);
                }
            }
        }
    }

    private void addTile(Slice slice, int tile, long untilUs) {
        int end = slice.firstFrom(tile, untilUs);
        long sinceFromUs = slice.fromUs - fromUs;
        int j = slice.firstFrom(tile, fromUs);
        while (j < end) {
            int step = projection.step(sinceFromUs + slice.afterUs(j));
            long stepUntilUs = projection.untilUs(step) - sinceFromUs;
            int part = Math.min(TraceMap.PARTS - 1, step / STEPS);
            projection.goTo(step);
            do {
                int eventX = slice.x(j);
                int eventY = slice.y(j);
                double x = projection.x(eventX, eventY);
                double y = projection.y(eventX, eventY);
                if (x > left - BESIDE_PX && x < right + BESIDE_PX && y > top - BESIDE_PX && y < bottom + BESIDE_PX) {
                    int label = window.label[window.at(slice.event(j))];
                    int whose = label == 0 ? TraceMap.NOBODYS : label == ownLabel ? TraceMap.OWN : TraceMap.OTHERS;
                    others += whose == TraceMap.OTHERS ? 1 : 0;
                    map.add(x, y, slice.isOn(j), part, whose);
                }
                j++;
            } while (j < end && slice.afterUs(j) < stepUntilUs);
        }
    }

    /** Looks up the claims to the open events of a block in the map. */
    private void ask(SegmentPath path, Slice slice, long a, long b, boolean shows) {
        for (int row = tile(top, slice.rows()); row <= tile(bottom, slice.rows()); row++) {
            for (int column = tile(left, slice.columns()); column <= tile(right, slice.columns()); column++) {
                int tile = row * slice.columns() + column;
                if (slice.isOpen(tile)) {
                    askTile(path, slice, tile, a, b, shows);
                }
            }
        }
    }

    private void askTile(SegmentPath path, Slice slice, int tile, long a, long b, boolean shows) {
        int end = slice.start(tile + 1);
        for (int j = slice.firstFrom(tile, a); j < end; j++) {
            int afterUs = slice.afterUs(j);
            if (afterUs >= b - slice.fromUs) {
                return;
            }
            int step = projection.step(slice.fromUs - fromUs + afterUs);
            projection.goTo(step);
            int eventX = slice.x(j);
            int eventY = slice.y(j);
            double x = projection.x(eventX, eventY);
            double y = projection.y(eventX, eventY);
            if (x < left || x > right || y < top || y > bottom) {
                continue;
            }
            long event = slice.event(j);
            boolean isOwn = window.segment[window.at(event)] == path.id();
            int part = step / STEPS;
            long wanted = TraceMap.parts(part - SIDE_PARTS, part + SIDE_PARTS + 1) & ~(1L << part);
            double score = isOwn ? MOST : 0;
            if (shows) {
                score = map.claim(x, y, slice.isOn(j), wanted, NOBODYS, othersWeight)
                    * raised(Long.bitCount(wanted & recorded));
            }
            if (isOwn) {
                score += PRIOR;
            }
            int i = (int) (event - slice.from);
            if (score > claim[i] && score > (isOwn ? leastLabelled : least)) {
                claim[i] = score;
                winner[i] = path.id();
            }
        }
    }

    /** Factor by which a claim is raised when only so many parts of the travel can show. */
    private static double raised(int parts) {
        return Math.min(MOST_RAISED, 2.0 * SIDE_PARTS / Math.max(1, parts));
    }
}
