package io.github.sofas.flow.search;

import io.github.sofas.flow.fit.MetricFit;

/**
 * Hands a structure of texture all events around it that move alike. It asks the {@link Surroundings}, hands their
 * events over, and finds the same events in the flow plane, some at a time. The structure is new, or is tracked and due
 * to look around itself again ({@link SpreadingTextures}).
 */
final class TakingOver {
    /** Votes that cost as much as going through an event that may be handed to a structure. */
    private static final int HANDED_VOTES = 24;
    /** Most events that are gone through at once, between two slices, for a structure that is tracked. */
    private static final int MOST_SEEN = 4096;
    /** Votes that each event earns in addition to those of the search, since labels wait. */
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
    /** The structure. A new one is created only when there is something to hand to it. */
    private Structures.Structure structure;
    private double vx;
    private double vy;
    /** Whether the structure has received its surroundings. */
    private boolean hasHanded;
    /** The next event of the flow plane to look at. */
    private int gathered;

    /** Creates an instance for a flow plane. Events that are handed over are added to {@code taken}. */
    TakingOver(FlowPlane plane, MetricFit fit, Structures structures, TakenEvents taken, VoteBudget budget) {
        this.plane = plane;
        this.structures = structures;
        this.taken = taken;
        this.budget = budget;
        events = plane.events();
        surroundings = new Surroundings(plane.sensor(), plane.recent(), fit);
    }

    /** Begins with a piece that shows a structure, by its velocity in px/s; its places are to be added. */
    void begin(double structureVx, double structureVy) {
        vx = structureVx;
        vy = structureVy;
        begin();
        surroundings.begin(vx, vy, plane.recent().newestUs());
    }

    /** Begins with a dense region that shows a structure. */
    void begin(RegionRefinement region) {
        vx = region.vx();
        vy = region.vy();
        begin();
        surroundings.begin(vx, vy, region.windowS(), region.left(), region.top(), plane.recent().newestUs());
    }

    private void begin() {
        taken.clear();
        hasHanded = false;
        stage = Stage.ASKING;
    }

    /** Adds a place of the new structure, that of an event of the flow plane. */
    void addPlace(int event) {
        surroundings.addPlace(events.x(event), events.y(event), events.timeUs(event));
    }

    /** Whether a tracked structure may be due to look around itself. */
    boolean isAnyDue() {
        return spreading.isAnyDue(plane.recent().newestUs());
    }

    /** Begins with a tracked structure that is due; returns whether there is one. */
    boolean beginWithDue() {
        structure = spreading.due(plane.recent().newestUs());
        if (structure == null) {
            return false;
        }
        begin();
        surroundings.begin(structure, plane.recent().newestUs());
        return true;
    }

    /** Whether nothing is left to do. */
    boolean isOver() {
        return stage == Stage.OVER;
    }

    /** Whether the structure has received anything. */
    boolean hasHanded() {
        return hasHanded;
    }

    /** Whether the structure is new, and a piece of the flow plane. */
    boolean isOfPiece() {
        return surroundings.isOfPiece();
    }

    /** Whether the next step has to wait until no other thread works with the structure. */
    boolean waits() {
        return stage == Stage.HANDING && surroundings.isOfTracked();
    }

    /** Earns the additional votes of another event. */
    void earn() {
        budget.earnMore(VOTES_PER_EVENT);
    }

    /**
     * Makes the next step.
     *
     * @param fewest least number of events of a tile that is asked
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

    /** Hands some events to a structure that is tracked. */
    void handToTracked() {
        for (int seen = 0; seen < MOST_SEEN && waits();) {
            seen += hand();
        }
    }

    private void ask(int fewest) {
        if (!surroundings.isAsked()) {
            budget.spend(surroundings.ask(fewest));
        } else if (!surroundings.isAny() || !surroundings.isOfTracked() && structures.isFull()) {
            stage = Stage.OVER;
        } else {
            budget.letGo();
            if (!surroundings.isOfTracked()) {
                structure = structures.create(plane.recent().newestUs(), vx, vy);
            }
            stage = Stage.HANDING;
        }
    }

    /** Hands some events over; returns the number of events gone through. */
    private int hand() {
        if (surroundings.isOfTracked() && !structure.isTracked()) {
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
        // there may be less room for structures by now
        hasHanded = surroundings.isOfTracked() || !structures.isFull();
        stage = hasHanded ? Stage.GATHERING : Stage.OVER;
        gathered = events.first(surroundings.seenFromUs());
        if (hasHanded && !surroundings.isOfTracked()) {
            long nowUs = plane.recent().newestUs();
            structure.begin(nowUs);
            spreading.add(structure, nowUs);
        }
    }

    /** Looks through some of the flow plane's events for those that were handed over. */
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

    /** Forgets the work under way, and all structures. */
    void clear() {
        stage = Stage.OVER;
        spreading.clear();
    }
}
