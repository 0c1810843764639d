package io.github.sofas.flow.search;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.SofasParameters;
import java.util.Arrays;

/**
 * The flow plane (paper, section Flow Plane): projections of the events that no track plane takes, each with an
 * accumulator of signed votes and its metric, kept incrementally.
 *
 * <p>Ours: each of the {@link Projections} holds the events of the time in which its own velocity travels a number of
 * pixels, so that slow and fast structures are looked for at once and on equal terms. Events are added in blocks
 * ({@link VoteBlock}), projection by projection, so that an accumulator stays in the first-level cache.
 */
public final class FlowPlane {
    /** Most events, and longest time, between two settlings: how late a structure may be found. */
    private static final int SETTLING = 256;
    private static final long SETTLING_US = 2_000;
    private static final int BLOCK = VoteBlock.CAPACITY;
    /** Part of a ring's window after which it takes its events in, where they are no block yet. */
    private static final int WINDOW_PARTS = 16;
    /**
     * Most events that a ring holds, less what it takes in at a time; where more come, the oldest go early. Enough for
     * 700,000 events per second that no track plane takes; memory is to be bounded.
     */
    private static final int MOST_EVENTS = FlowPlaneEvents.MOST_HELD - 2 * BLOCK;

    /** Events that a ring lets go before their votes are taken out at the latest; they are held in the meantime. */
    private static final int MOST_GONE = BLOCK / 2;

    private final SensorSize sensor;
    private final Projections projections;
    private final int n;
    private final FlowPlaneEvents events = new FlowPlaneEvents();
    private final RecentEvents recent;
    private final SearchedTiles searched;
    private final short[][] f;
    private final long[] metric;
    /** Events whose votes the projections of a speed have. */
    private final int[] count;
    /** Number of the oldest event held by the projections of a speed. */
    private final int[] oldest;
    /** Number after the newest event held by the projections of a speed, and when it was taken in. */
    private final int[] end;
    private final long[] settledUs;
    /** Numbers of the oldest event whose vote the projections of a speed have, and after the newest. */
    private final int[] votedFrom;
    private final int[] votedTo;

    /** Number after the newest event that the last settling saw. */
    private int settled;
    private long epochUs;
    /** Time of the oldest event since. */
    private long waitingUs;
    private long total;
    private boolean started;

    /** Events that a ring is to take in, and that are to leave it. */
    private final VoteBlock coming;
    private final VoteBlock leaving;

    /** Makes an empty plane for a sensor of so many px. */
    public FlowPlane(int sensorWidth, int sensorHeight, SofasParameters.Search p) {
        projections = new Projections(sensorWidth, sensorHeight, p);
        n = projections.n();
        sensor = new SensorSize(sensorWidth, sensorHeight);
        recent = new RecentEvents(sensor);
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

    /** The most bytes that its arrays take. */
    static long mostBytes(SensorSize sensor, SofasParameters.Search p) {
        return Projections.cells(sensor) * p.flowProjections() * p.flowProjections() * Short.BYTES
            + FlowPlaneEvents.mostBytes() + RecentEvents.bytes(sensor);
    }

    /** Adds an event, which waits to be projected where its tile is searched. */
    public void add(int eventX, int eventY, long eventUs, int polarity) {
        recent.add(eventX, eventY, eventUs, polarity);
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

    /** Whether events wait to be projected, enough of them or long enough. */
    public boolean isToSettle(long nowUs) {
        int waiting = events.head() - settled;
        return waiting == SETTLING || waiting != 0 && nowUs - waitingUs > SETTLING_US;
    }

    /**
     * Lets each ring take in the events that came, and those go that it has held long enough; a slow ring not at each
     * block, because few events at a time are dear: each accumulator has to come into the cache first. For the same
     * reason they vote only when they are a block, or asked for: in between many come and go.
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

    /** Lets the events go that a ring has held long enough. */
    private void release(int ring, long limitUs) {
        int e = oldest[ring];
        while (e != end[ring] && isOver(e, limitUs)) {
            e++;
        }
        oldest[ring] = e;
        if (votedTo[ring] - e <= 0 && count[ring] == 0) {
            // they have come and gone
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

    /** Lets a ring's projections have the votes of all events that it holds, and of no others. */
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

    /** Adds the events that come to the accumulators of a ring, and takes those that leave out again. */
    private void vote(int ring) {
        coming.tick(projections.tickBits(ring));
        leaving.tick(projections.tickBits(ring));
        for (int k = ring * n; k < ring * n + n; k++) {
            // one after the other: the accumulator is in the first-level cache then
            metric[k] += coming.vote(f[k], projections.unitsPerTickX(k), projections.unitsPerTickY(k), 1);
            metric[k] += leaving.vote(f[k], projections.unitsPerTickX(k), projections.unitsPerTickY(k), -1);
        }
        count[ring] += coming.size() - leaving.size();
        coming.clear();
        leaving.clear();
    }

    /**
     * Takes events out of the projections of a speed, or keeps them out of it where it has not come yet.
     *
     * @param numbers of the events, those of the places from one to before another
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

    /** Finds the cells that the events fall on which a projection has the votes of. */
    void findHeld(int k, HeldCells held) {
        int ring = k / n;
        if (oldest[ring] == end[ring]) {
            held.set(0, 0, 0, 0);
        } else {
            projections.findHeld(k, events.timeUs(oldest[ring]) - epochUs, events.timeUs(end[ring] - 1) - epochUs,
                sensor, held);
        }
    }

    /** The velocities, and the cells. */
    Projections projections() {
        return projections;
    }

    /** The events that any ring holds or is to take in yet. */
    FlowPlaneEvents events() {
        return events;
    }

    /** The newest events that came, also of tiles that are not searched. */
    RecentEvents recent() {
        return recent;
    }

    /** Accumulator of a projection, read only, as it was when its ring caught up last. */
    short[] accumulator(int k) {
        return f[k];
    }

    /** The same, its metric. */
    long metric(int k) {
        return metric[k];
    }

    /** Events held by the projections of a speed, which catch up. */
    int count(int ring) {
        catchUp(ring);
        return count[ring];
    }

    /** Whether only some of the sensor's tiles are searched. */
    boolean isThinned() {
        return searched.isThinned();
    }

    /** The pixels that events come from. */
    SensorSize sensor() {
        return sensor;
    }

    /** Number of the oldest event that the projections of a speed hold. */
    int oldest(int ring) {
        return oldest[ring];
    }

    /** Number after the newest event that the projections of a speed hold. */
    int end(int ring) {
        return end[ring];
    }

    /** How many events ever came. */
    public long total() {
        return total;
    }

    /** Metric an event held of each projection, to be shown; 0 where it holds none. */
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
        searched.reset();
        settled = 0;
        total = 0;
        started = false;
    }
}
