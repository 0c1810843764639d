package io.github.sofas.flow.search;

import io.github.sofas.flow.motion.Bounds;
import io.github.sofas.flow.motion.Motion;
import java.util.ArrayList;
import java.util.List;

/**
 * Recognises a piece of the flow plane as a part of a structure that is tracked: its events meet nearly as often along
 * the motion of a structure around it as along the piece's own velocity.
 *
 * <p>Ours: a wall before a camera has some such parts each px of travel, where its contour does not hold yet, or has
 * lost, what is there. Each of them was tracked by itself, with a velocity of few events, until it merged. A structure
 * that does not know its velocity along both axes, as a straight edge, has no parts: what slides along it would explain
 * any edge that is parallel to it.
 *
 * <p>What is tracked is known as it was when it was told of last, since others may track it now; for the same reason
 * the events of parts wait until they may be shown.
 */
public final class Recognition {
    /** Most events that wait: what is more than there is room for is recognised as no part. */
    private static final int MOST_WAITING = 1 << 14;
    /** Bytes of its arrays. */
    static final long BYTES = 2L * Integer.BYTES * MOST_WAITING;

    /** Share of its metric that a part may lose, and standard deviations: its own velocity is fitted to noise, too. */
    private static final double MOST_LOST = 0.02;
    private static final double LOST_SIGMAS = 1;
    /** A structure has so many times the events of a part: of a small one, a part is as well known as the whole. */
    private static final int LEAST_TIMES = 2;
    /** Distance from the box of the structure within which a part lies, in px. */
    private static final double GAP_PX = 4;

    private final Structures structures;
    private final FlowPlaneEvents events;
    private final List<Known> known = new ArrayList<>();
    private int knownSize;
    /** Events that wait, by their number in the flow plane, and the structure that each is for. */
    private final int[] waiting = new int[MOST_WAITING];
    private final int[] receiver = new int[MOST_WAITING];
    private int waitingSize;

    /** A structure that is tracked. */
    public static final class Known {
        private final Motion motion = new Motion();
        private final Bounds box = new Bounds();
        private int id;
        private long size;

        /** How it moves; to be set. */
        public Motion motion() {
            return motion;
        }

        /** The box that it lies in, in px of the sensor; to be set. */
        public Bounds box() {
            return box;
        }
    }

    Recognition(Structures structures, FlowPlaneEvents events) {
        this.structures = structures;
        this.events = events;
    }

    /** Has itself told anew what is tracked; not while others track it. */
    void look(long nowUs) {
        knownSize = 0;
        structures.tell(this, nowUs);
    }

    /**
     * Has a structure among those that are tracked.
     *
     * @param id number of the structure, from 1 on
     * @param size how many events it gave over the travel that its motion is measured over
     * @return what else is to be told of it
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
     * The structure that a piece is a part of.
     *
     * @param numbers of the piece's events in the flow plane, in order of time, from a place on
     * @param refined the piece's velocity
     * @return its number; 0 where the piece is part of none that is tracked
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

    /** Has an event of a part wait until it may be shown to the structure. */
    void give(int id, int event) {
        waiting[waitingSize] = event;
        receiver[waitingSize] = id;
        waitingSize++;
    }

    /** Whether any event waits. */
    boolean waits() {
        return waitingSize > 0;
    }

    /** Shows the events that wait to their structures; not while others track these. */
    void show(long nowUs) {
        for (int i = 0; i < waitingSize; i++) {
            int e = waiting[i];
            if (events.holds(e)) {
                structures.see(receiver[i], events.x(e), events.y(e), events.timeUs(e), events.sign(e), nowUs);
            }
        }
        waitingSize = 0;
    }

    /** Forgets all. */
    void clear() {
        knownSize = 0;
        waitingSize = 0;
    }
}
