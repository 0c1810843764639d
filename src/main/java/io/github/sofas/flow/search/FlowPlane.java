package io.github.sofas.flow.search;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.SofasParameters;
import java.util.Arrays;

/**
 * The flow plane (paper, section Flow Plane): projections of the events that no track plane takes. Each projection has
 * an accumulator of signed votes and its metric, which is kept incrementally.
 *
 * <p>Ours: the {@link Projections} of one speed form a ring, and hold the events of the time in which this speed
 * travels a fixed number of pixels. Slow and fast structures are thus searched at once and on equal terms. Events are
 * added in blocks ({@link VoteBlock}), projection by projection, so that an accumulator stays in the first-level cache.
 */
public final class FlowPlane {
    /** Most events, and longest time, between two settlings: the delay with which a structure may be found. */
    private static final int SETTLING = 256;
    private static final long SETTLING_US = 2_000;
    private static final int BLOCK = VoteBlock.CAPACITY;
    /**
     * Number of parts of a ring's window. After one part, the ring takes in its events even if they do not fill a
     * block.
     */
    private static final int WINDOW_PARTS = 16;
    /**
     * Most events that a ring holds: those that fit, less the events that it takes in at a time. Where more come, the
     * oldest leave early. The limit bounds memory, and is enough for 700,000 events per second that no track plane
     * takes.
     */
    private static final int MOST_EVENTS = FlowPlaneEvents.MOST_HELD - 2 * BLOCK;

    /** Most events that leave a ring before their votes are taken out; until then the events are kept. */
    private static final int MOST_GONE = BLOCK / 2;

    private final SensorSize sensor;
    private final Projections projections;
    private final int n;
    private final FlowPlaneEvents events = new FlowPlaneEvents();
    private final RecentEvents recent;
    private final DenseRegions regions;
    private final SearchedTiles searched;
    private final short[][] f;
    private final long[] metric;
    /** By ring, the number of events whose votes the accumulators hold. */
    private final int[] count;
    /** By ring, the number of the oldest event held. */
    private final int[] oldest;
    /** By ring, the number after the newest event held, and the time when the ring last took in events. */
    private final int[] end;
    private final long[] settledUs;
    /** By ring, the number of the oldest event whose vote the accumulators hold, and the number after the newest. */
    private final int[] votedFrom;
    private final int[] votedTo;

    /** Number after the newest event that the last settling saw. */
    private int settled;
    private long epochUs;
    /** Time of the oldest event since the last settling. */
    private long waitingUs;
    private long total;
    private boolean started;

    /** Events whose votes a ring is to take in, and those whose votes are to leave it. */
    private final VoteBlock coming;
    private final VoteBlock leaving;

    /** Creates an empty plane for a sensor of the given size in px. */
    public FlowPlane(int sensorWidth, int sensorHeight, SofasParameters.Search p) {
        projections = new Projections(sensorWidth, sensorHeight, p);
        n = projections.n();
        sensor = new SensorSize(sensorWidth, sensorHeight);
        recent = new RecentEvents(sensor);
        regions = new DenseRegions(sensor, recent);
        searched = new SearchedTiles(sensor);
        coming = new VoteBlock(projections.columnBits(), projections.rowBits());
        leaving = new VoteBlock(projections.columnBits(), projections.rowBits());
        f = new short[n * n][projections.cells()];
        metric = new long[n * n];
        count = new int[n];
        oldest = new int[n];
        end = new int[n];
        settledUs = new long[n];
        votedFrom = new int[n];
        votedTo = new int[n];
    }

    /** Most bytes of the arrays of a flow plane. */
    static long mostBytes(SensorSize sensor, SofasParameters.Search p) {
        return Projections.cells(sensor) * p.flowProjections() * p.flowProjections() * Short.BYTES
            + FlowPlaneEvents.mostBytes() + RecentEvents.bytes(sensor) + DenseRegions.bytes(sensor);
    }

    /** Adds an event. If its tile is searched, the event waits to be projected. */
    public void add(int eventX, int eventY, long eventUs, int polarity) {
        recent.add(eventX, eventY, eventUs, polarity);
        regions.add(eventX, eventY, eventUs);
        if (!searched.takes(eventX, eventY, eventUs)) {
            return;
        }
        if (!started) {
            started = true;
            epochUs = eventUs;
            Arrays.fill(settledUs, eventUs);
        }
        if (events.head() == settled) {
            waitingUs = eventUs;
        }
        events.add(eventX, eventY, eventUs, polarity);
    }

    /** Whether enough events wait to be projected, or some have waited long enough. */
    public boolean mustSettle(long nowUs) {
        int waiting = events.head() - settled;
        return waiting == SETTLING || waiting != 0 && nowUs - waitingUs > SETTLING_US;
    }

    /**
     * Lets each ring take in the events that came, and release those that it has held long enough. A slow ring does not
     * do so at each settling, because few events at a time are expensive: each accumulator has to come into the cache
     * first. For the same reason, events vote only when they fill a block or when their votes are asked for: until
     * then, many come and go.
     */
    public void settle(long nowUs) {
        int head = events.head();
        total += head - settled;
        settled = head;
        int first = head;
        int firstVoted = head;
        for (int i = 0; i < n; i++) {
            if (head - end[i] >= BLOCK || (nowUs - settledUs[i]) * WINDOW_PARTS >= projections.windowUs(i)) {
                settledUs[i] = nowUs;
                end[i] = head;
                release(i, nowUs - projections.windowUs(i));
            }
            first = oldest[i] - first < 0 ? oldest[i] : first;
            firstVoted = votedFrom[i] - firstVoted < 0 ? votedFrom[i] : firstVoted;
        }
        events.letGo(first, firstVoted);
    }

    /** Releases the events that a ring has held long enough. */
    private void release(int ring, long limitUs) {
        int e = oldest[ring];
        while (e != end[ring] && isOver(e, limitUs)) {
            e++;
        }
        oldest[ring] = e;
        if (votedTo[ring] - e <= 0 && count[ring] == 0) {
            // all events since have come and gone without a vote
            votedFrom[ring] = e;
            votedTo[ring] = e;
        }
        if (end[ring] - votedTo[ring] >= BLOCK || e - votedFrom[ring] >= MOST_GONE) {
            catchUp(ring);
        }
    }

    private boolean isOver(int event, long limitUs) {
        return events.timeUs(event) < limitUs || events.head() - event > MOST_EVENTS;
    }

    /**
     * Brings the accumulators of a ring up to date: they then hold the votes of all events of the ring, and no others.
     */
    void catchUp(int ring) {
        int from = oldest[ring];
        int to = end[ring];
        if (votedFrom[ring] == from && votedTo[ring] == to) {
            return;
        }
        int leave = votedFrom[ring];
        int left = votedTo[ring] - from < 0 ? votedTo[ring] : from;
        int come = votedTo[ring] - from < 0 ? from : votedTo[ring];
        do {
            for (int room = BLOCK; leave != left && room > 0; room--) {
                gather(ring, leave++, leaving);
            }
            for (int room = BLOCK; come != to && room > 0; room--) {
                gather(ring, come++, coming);
            }
            vote(ring);
        } while (leave != left || come != to);
        votedFrom[ring] = from;
        votedTo[ring] = to;
    }

    /** Adds an event to a block unless it was taken out of the ring. */
    private void gather(int ring, int event, VoteBlock block) {
        if (!events.isTakenOut(ring, event)) {
            block.add(events.x(event), events.y(event), events.timeUs(event) - epochUs, events.sign(event));
        }
    }

    /** Adds the votes of the coming events to the accumulators of a ring, and takes out those of the leaving events. */
    private void vote(int ring) {
        coming.tick(projections.tickBits(ring));
        leaving.tick(projections.tickBits(ring));
        for (int k = ring * n; k < ring * n + n; k++) {
            // both blocks in turn: the accumulator is in the first-level cache then
            metric[k] += coming.vote(f[k], projections.unitsPerTickX(k), projections.unitsPerTickY(k), 1);
            metric[k] += leaving.vote(f[k], projections.unitsPerTickX(k), projections.unitsPerTickY(k), -1);
        }
        count[ring] += coming.size() - leaving.size();
        coming.clear();
        leaving.clear();
    }

    /**
     * Takes events out of a ring. An event that has not voted there yet is kept from voting.
     *
     * @param numbers the numbers of the events, from the place {@code from} to before {@code to}
     */
    void takeOut(int ring, int[] numbers, int from, int to) {
        for (int a = from; a < to; a++) {
            int e = numbers[a];
            if (!events.holds(e)) {
                continue;
            }
            if (e - votedFrom[ring] >= 0 && e - votedTo[ring] < 0) {
                gather(ring, e, leaving);
            }
            events.takeOut(ring, e);
            if (leaving.isFull()) {
                vote(ring);
            }
        }
        vote(ring);
    }

    /** Cell of an event in a projection. */
    int cell(int k, int event) {
        return projections.cell(k, events.x(event), events.y(event), events.timeUs(event) - epochUs);
    }

    /** Finds the cells on which the events held by a projection fall. */
    void findHeld(int k, HeldCells held) {
        int ring = k / n;
        if (oldest[ring] == end[ring]) {
            held.set(0, 0, 0, 0);
        } else {
            projections.findHeld(k, events.timeUs(oldest[ring]) - epochUs, events.timeUs(end[ring] - 1) - epochUs,
                sensor, held);
        }
    }

    /** The projections: velocities and cells. */
    Projections projections() {
        return projections;
    }

    /** The events that any ring holds or has yet to take in. */
    FlowPlaneEvents events() {
        return events;
    }

    /** The newest events, including those of tiles that are not searched. */
    RecentEvents recent() {
        return recent;
    }

    /** The regions of the sensor with many of the newest events. */
    DenseRegions regions() {
        return regions;
    }

    /** Accumulator of a projection, read only, as of the time when its ring last caught up. */
    short[] accumulator(int k) {
        return f[k];
    }

    /** Metric of a projection, as of the time when its ring last caught up. */
    long metric(int k) {
        return metric[k];
    }

    /** Number of events whose votes a ring holds; the ring catches up first. */
    int count(int ring) {
        catchUp(ring);
        return count[ring];
    }

    /** Whether only some of the sensor's tiles are searched. */
    boolean isThinned() {
        return searched.isThinned();
    }

    /** The size of the sensor. */
    SensorSize sensor() {
        return sensor;
    }

    /** Number of the oldest event that a ring holds. */
    int oldest(int ring) {
        return oldest[ring];
    }

    /** Number after the newest event that a ring holds. */
    int end(int ring) {
        return end[ring];
    }

    /** Number of events that were settled since the start. */
    public long total() {
        return total;
    }

    /** Metric per held event of each projection, for display; 0 for a projection that holds no events. */
    public float[] metricsPerEvent() {
        float[] perEvent = new float[n * n];
        for (int k = 0; k < perEvent.length; k++) {
            int held = count(k / n);
            perEvent[k] = held == 0 ? 0 : (float) metric[k] / held;
        }
        return perEvent;
    }

    /** Forgets all events. */
    public void reset() {
        for (short[] cells : f) {
            Arrays.fill(cells, (short) 0);
        }
        Arrays.fill(metric, 0);
        Arrays.fill(count, 0);
        Arrays.fill(oldest, 0);
        Arrays.fill(end, 0);
        Arrays.fill(votedFrom, 0);
        Arrays.fill(votedTo, 0);
        events.clear();
        recent.clear();
        regions.clear();
        searched.reset();
        settled = 0;
        total = 0;
        started = false;
    }
}
