package io.github.sofas.flow.search;

import io.github.sofas.flow.fit.MetricFit;

/**
 * Hands all that moves alike around a structure of texture to it: asks its {@link Surroundings}, hands them over, and
 * finds those events in the flow plane, some at a time. A structure is new, or is tracked and due to look around itself
 * again ({@link SpreadingTextures}).
 */
final class TakingOver {
    /** Votes that cost as much as handing an event to a structure. */
    private static final int HANDED_VOTES = 24;
    /** Most events that are gone through at once to be handed to a structure which is tracked, between two slices. */
    private static final int MOST_SEEN = 4096;
    /** Votes that an event earns beside those of the search, since labels wait. */
    private static final int VOTES_PER_EVENT = 480;

    private enum Stage { ASKING, HANDING, GATHERING, OVER }

    private final FlowPlane plane;
    private final FlowPlaneEvents events;
    private final Structures structures;
    private final TakenEvents taken;
    private final VoteBudget budget;
    private final Surroundings surroundings;
    private final SpreadingTextures spreading = new SpreadingTextures();

    private Stage stage = Stage.OVER;
    /** The structure: a new one is made when there is something to be handed to it. */
    private Structures.Structure structure;
    private double vx;
    private double vy;
    /** Whether the structure got what surrounds it. */
    private boolean hasHanded;
    /** The next event of the flow plane that is looked at. */
    private int gathered;

    /** Makes it for a flow plane; what is handed over is noted as taken. */
    TakingOver(FlowPlane plane, MetricFit fit, Structures structures, TakenEvents taken, VoteBudget budget) {
        this.plane = plane;
        this.structures = structures;
        this.taken = taken;
        this.budget = budget;
        events = plane.events();
        surroundings = new Surroundings(plane.sensor(), plane.recent(), fit);
    }

    /** Begins with the velocity of a new structure in px/s; its places are to be added. */
    void begin(double structureVx, double structureVy) {
        vx = structureVx;
        vy = structureVy;
        begin();
        surroundings.begin(vx, vy, plane.recent().newestUs());
    }

    private void begin() {
        taken.clear();
        hasHanded = false;
        stage = Stage.ASKING;
    }

    /** Adds a place of the new structure: that of an event of the flow plane. */
    void addPlace(int event) {
        surroundings.addPlace(events.x(event), events.y(event), events.timeUs(event));
    }

    /** Whether a structure that is tracked may be due to look around itself. */
    boolean isAnyDue() {
        return spreading.isAnyDue(plane.recent().newestUs());
    }

    /** Begins with a structure that is tracked and due; returns whether there is one. */
    boolean beginWithDue() {
        structure = spreading.due(plane.recent().newestUs());
        if (structure == null) {
            return false;
        }
        begin();
        surroundings.begin(structure, plane.recent().newestUs());
        return true;
    }

    /** Whether nothing is left to be done. */
    boolean isOver() {
        return stage == Stage.OVER;
    }

    /** Whether the structure got anything. */
    boolean hasHanded() {
        return hasHanded;
    }

    /** Whether the structure was tracked before. */
    boolean isOfTracked() {
        return surroundings.isOfTracked();
    }

    /** Whether it goes on only while nobody else works with the structure. */
    boolean waits() {
        return stage == Stage.HANDING && isOfTracked();
    }

    /** Earns votes with another event. */
    void earn() {
        budget.earnMore(VOTES_PER_EVENT);
    }

    /**
     * Goes on by a step.
     *
     * @param fewest events of a tile that is asked
     */
    void goOn(int fewest) {
        switch (stage) {
            case ASKING:
                ask(fewest);
                break;
            case HANDING:
                budget.spend((long) hand() * HANDED_VOTES);
                break;
            case GATHERING:
                gather();
                break;
            default:
        }
    }

    /** Hands some to a structure that is tracked. */
    void handToTracked() {
        for (int seen = 0; seen < MOST_SEEN && waits();) {
            seen += hand();
        }
    }

    private void ask(int fewest) {
        if (!surroundings.isAsked()) {
            budget.spend(surroundings.ask(fewest));
        } else if (!surroundings.isAny() || !isOfTracked() && structures.isFull()) {
            stage = Stage.OVER;
        } else {
            budget.letGo();
            structure = isOfTracked() ? structure : structures.create(plane.recent().newestUs(), vx, vy);
            stage = Stage.HANDING;
        }
    }

    /** Hands some events over; returns how many it has gone through. */
    private int hand() {
        if (isOfTracked() && !structure.isTracked()) {
            stage = Stage.OVER;
            return 0;
        }
        int handed = surroundings.hand(structure);
        if (surroundings.isHanded()) {
            endHanding();
        }
        return handed;
    }

    private void endHanding() {
        // fewer may be allowed by now
        hasHanded = isOfTracked() || !structures.isFull();
        stage = hasHanded ? Stage.GATHERING : Stage.OVER;
        gathered = events.first(surroundings.seenFromUs());
        if (hasHanded && !isOfTracked()) {
            long nowUs = plane.recent().newestUs();
            structure.begin(nowUs);
            spreading.add(structure, nowUs);
        }
    }

    /** Looks through some of the flow plane's events for what was handed over. */
    private void gather() {
        gathered = events.holds(gathered) ? gathered : events.oldest();
        int end = gathered + Math.min(Surroundings.AT_ONCE, events.head() - gathered);
        budget.spend(Surroundings.AT_ONCE / Surroundings.EVENTS_PER_VOTE);
        for (; gathered != end; gathered++) {
            if (!events.isTakenOut(gathered)
                    && surroundings.has(events.x(gathered), events.y(gathered), events.timeUs(gathered))) {
                taken.add(gathered);
            }
        }
        if (gathered == events.head()) {
            stage = Stage.OVER;
        }
    }

    /** Forgets what is under way, and all structures. */
    void clear() {
        stage = Stage.OVER;
        spreading.clear();
    }
}
