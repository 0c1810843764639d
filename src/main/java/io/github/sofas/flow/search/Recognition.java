package io.github.sofas.flow.search;

import io.github.sofas.flow.motion.Bounds;
import io.github.sofas.flow.motion.Motion;
import java.util.ArrayList;
import java.util.List;

/**
 * Recognises a piece of the flow plane as a part of a structure that is already tracked: the events of the piece meet
 * nearly as often along the motion of a structure around it as along the piece's own velocity.
 *
 * <p>Ours: a wall before a camera gives some such parts per pixel of travel, where its contour does not hold the
 * texture yet, or has lost it. Without recognition, each part is tracked by itself, with a velocity of few events,
 * until it merges. A structure whose velocity is not known along both axes, such as a straight edge, has no parts: by
 * sliding along itself, it would explain any parallel edge.
 *
 * <p>The tracked structures are known as they were at the last {@link #look}, since another thread may track them now.
 * For the same reason, the events of parts wait until they may be shown to their structures ({@link #show}).
 */
public final class Recognition {
    /** Most events that wait. A piece whose events do not fit is recognised as no part. */
    private static final int MOST_WAITING = 1 << 14;
    /** Bytes of the arrays. */
    static final long BYTES = 2L * Integer.BYTES * MOST_WAITING;

    /**
     * Share of its metric that a part may lose, and standard deviations of the metric that it may lose in addition: its
     * own velocity is fitted to noise, too.
     */
    private static final double MOST_LOST = 0.02;
    private static final double LOST_SIGMAS = 1;
    /**
     * Least ratio of the events of a structure to those of a part: a part of a small structure is known as well as the
     * whole.
     */
    private static final int LEAST_TIMES = 2;
    /** Largest distance of a part from the box of the structure, in px. */
    private static final double GAP_PX = 4;

    private final Structures structures;
    private final FlowPlaneEvents events;
    private final List<Known> known = new ArrayList<>();
    private int knownSize;
    /** Events that wait, by their number in the flow plane, and the id of the structure for which each waits. */
    private final int[] waiting = new int[MOST_WAITING];
    private final int[] receiver = new int[MOST_WAITING];
    private int waitingSize;

    /** A structure that is tracked. */
    public static final class Known {
        private final Motion motion = new Motion();
        private final Bounds box = new Bounds();
        private int id;
        private long size;

        /** Motion of the structure, to be set by the caller. */
        public Motion motion() {
            return motion;
        }

        /** Box that holds the structure, in px of the sensor, to be set by the caller. */
        public Bounds box() {
            return box;
        }
    }

    Recognition(Structures structures, FlowPlaneEvents events) {
        this.structures = structures;
        this.events = events;
    }

    /** Looks anew which structures are tracked. Not to be called while another thread tracks them. */
    void look(long nowUs) {
        knownSize = 0;
        structures.report(this, nowUs);
    }

    /**
     * Adds a structure to those that are known to be tracked.
     *
     * @param id number of the structure, from 1 on
     * @param size number of events that the structure gave over the travel on which its motion is measured
     * @return the new entry, whose motion and box are to be set
     */
    public Known know(int id, long size) {
        if (knownSize == known.size()) {
            known.add(new Known());
        }
        Known its = known.get(knownSize++);
        its.id = id;
        its.size = size;
        its.box.clear();
        return its;
    }

    /**
     * Finds the structure of which a piece is a part.
     *
     * @param numbers the numbers of the piece's events in the flow plane, in order of time, from the place {@code from}
     *     on
     * @param refined the piece's velocity
     * @return id of the structure; 0 where the piece is a part of no tracked structure
     */
    int structureOf(int[] numbers, int from, int size, PieceRefinement refined) {
        if (waitingSize + size > MOST_WAITING) {
            return 0;
        }
        long sumX = 0;
        long sumY = 0;
        for (int a = from; a < from + size; a++) {
            sumX += events.x(numbers[a]);
            sumY += events.y(numbers[a]);
        }
        int x = (int) (sumX / size);
        int y = (int) (sumY / size);
        long firstUs = events.timeUs(numbers[from]);
        long lastUs = events.timeUs(numbers[from + size - 1]);
        long middleUs = firstUs + (lastUs - firstUs) / 2;
        double half = (lastUs - middleUs) * 1e-6;
        double least = MOST_LOST + LOST_SIGMAS * refined.noiseShare();
        int best = 0;
        for (int i = 0; i < knownSize; i++) {
            Known its = known.get(i);
            if (its.size >= (long) LEAST_TIMES * size
                    && its.box.isAround(x + refined.vx() * half, y + refined.vy() * half, GAP_PX)) {
                double lost =
                    refined.shareLost(its.motion.vxAt(x, y, middleUs), its.motion.vyAt(x, y, middleUs));
                if (lost < least) {
                    least = lost;
                    best = its.id;
                }
            }
        }
        return best;
    }

    /** Lets an event of a part wait until it may be shown to the structure. */
    void give(int id, int event) {
        waiting[waitingSize] = event;
        receiver[waitingSize] = id;
        waitingSize++;
    }

    /** Whether any event waits. */
    boolean waits() {
        return waitingSize > 0;
    }

    /** Shows the waiting events to their structures. Not to be called while another thread tracks these. */
    void show(long nowUs) {
        for (int i = 0; i < waitingSize; i++) {
            int e = waiting[i];
            if (events.holds(e)) {
                structures.see(receiver[i], events.x(e), events.y(e), events.timeUs(e), events.sign(e), nowUs);
            }
        }
        waitingSize = 0;
    }

    /** Forgets all structures and all waiting events. */
    void clear() {
        knownSize = 0;
        waitingSize = 0;
    }
}
