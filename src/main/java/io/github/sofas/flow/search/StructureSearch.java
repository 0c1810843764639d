package io.github.sofas.flow.search;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.SofasParameters;
import io.github.sofas.flow.fit.MetricFit;
import java.util.Arrays;

/**
 * Finds structures in the flow plane: the best projection, its pieces (paper, section Flow Plane) and the motion of
 * each; a piece that is a structure becomes a track plane. Because several structures may share the best projection
 * roughly, each piece is refined by itself; pieces of one structure are merged by who tracks them.
 *
 * <p>Ours: a look takes up to a thousand times as long as labelling an event, and is made in small parts between the
 * events that come in the meantime, so that none of them waits for it.
 */
public final class StructureSearch {
    /** Unmatched events between two looks, and cells of an accumulator for each where that is more. */
    private static final int EVERY = 128;
    private static final int EVERY_CELLS = 512;
    /** Standard deviations by which a metric must pass what chance gives. */
    private static final double CHANCE_SIGMAS = 6;
    /** Share of its events that a piece must have that were not looked at in vain before, and that no structure has. */
    private static final double NEWS = 0.25;
    /** Votes of the flow plane, and cells looked through, that cost as much as one vote of a fit. */
    private static final int CHEAP_VOTES = 2;
    private static final int CHEAP_CELLS = 4;

    /** Votes that a look in vain may give for each unmatched event until the next. */
    private static final int VAIN_VOTES = 10;

    private enum Stage { IDLE, CHOOSING, REFINING, TAKING_OUT }

    private final FlowPlane plane;
    private final Projections projections;
    private final FlowPlaneEvents events;
    private final int n;
    private final int every;
    private final long[] refusedUntil;
    private final Pieces pieces;
    private final PieceRefinement refinement;
    private final Surroundings surroundings;
    private final SpreadingTextures spreading = new SpreadingTextures();
    private final MetricFit fit;
    private final Structures structures;
    private final VoteBudget budget;
    private SofasParameters.Search p;

    private Stage stage = Stage.IDLE;
    private boolean mayBeSpread;
    private long nextLook;

    // the look that is under way: votes of the search before it, projection, its pieces, the one that is looked at
    private long votesBefore;
    private int projection;
    private boolean found;
    private int piece;
    private int count;
    private int from;
    private int size;

    // events that a structure has got and that are to be taken out of the rings, and of how many they are
    private int[] taken = new int[4096];
    private int takenSize;
    private int rings;

    /** The most bytes that the arrays of a search and of its flow plane take, but for those of its fit. */
    public static long mostBytes(SensorSize sensor, SofasParameters.Search p) {
        return FlowPlane.mostBytes(sensor, p) + Pieces.mostBytes(Projections.cells(sensor))
            + Surroundings.bytes(sensor);
    }

    /**
     * Makes a search in a flow plane, which hands what it finds to others.
     *
     * @param measuringVotes votes that the measurements of track planes gave so far, which it owes nothing for
     */
    public StructureSearch(FlowPlane plane, SofasParameters.Search p, MetricFit fit, Structures structures,
                           long measuringVotes) {
        budget = new VoteBudget(measuringVotes);
        this.plane = plane;
        projections = plane.projections();
        events = plane.events();
        this.structures = structures;
        this.p = p;
        this.fit = fit;
        n = projections.n();
        every = Math.max(EVERY, projections.cells() / EVERY_CELLS);
        refusedUntil = new long[n * n];
        pieces = new Pieces(plane);
        refinement = new PieceRefinement(fit, p);
        surroundings = new Surroundings(plane.sensor(), plane.recent(), fit);
    }

    /** Looks on with other parameters that leave the flow plane as it is. */
    public void setParameters(SofasParameters.Search next) {
        p = next;
        refinement.setParameters(next);
    }

    /**
     * Looks for structures as far as is due with another event.
     *
     * @param measuringVotes votes that the measurements of track planes gave so far
     */
    public void run(long measuringVotes) {
        run(measuringVotes, true);
    }

    /**
     * The same.
     *
     * @param spreads whether structures that are tracked may look around themselves; not while others track them
     */
    void run(long measuringVotes, boolean spreads) {
        mayBeSpread = spreads;
        budget.earn(measuringVotes);
        while (budget.isLeft() && isBusy()) {
            work();
        }
    }

    /** Lets a structure that is due look around itself, unless a look is under way. */
    void spread() {
        if (stage == Stage.IDLE) {
            spreadsOn();
        }
    }

    /** Whether a look is under way or due. */
    private boolean isBusy() {
        return stage != Stage.IDLE || plane.total() >= nextLook
            || mayBeSpread && spreading.isAnyDue(plane.recent().newestUs());
    }

    private void work() {
        switch (stage) {
            case CHOOSING:
                choose();
                break;
            case REFINING:
                refine();
                break;
            case TAKING_OUT:
                takeOut();
                break;
            default:
                look();
        }
    }

    /** Begins to look at the best projection, if there is one. */
    private void look() {
        if (mayBeSpread && spreadsOn() || plane.total() < nextLook) {
            return;
        }
        nextLook = plane.total() + every;
        int best = structures.isFull() ? -1 : best();
        if (best >= 0) {
            projection = best;
            found = false;
            votesBefore = fit.votes();
            count = pieces.find(best, p.thresholdSd());
            piece = 0;
            budget.spend(projections.cells() / CHEAP_CELLS + plane.count(best / n) / CHEAP_VOTES);
            stage = Stage.CHOOSING;
        }
    }

    /**
     * The projection whose metric gains most over chance in a time: signed votes at random places give one per event.
     * Per time, because slow projections hold events longer.
     */
    private int best() {
        int best = -1;
        double most = 0;
        for (int i = 0; i < n; i++) {
            int held = plane.count(i);
            if (held < p.minEvents()) {
                continue;
            }
            double least = Math.max(CHANCE_SIGMAS * held * Math.sqrt(2.0 / projections.cells()),
                p.evidence() * p.minEvents());
            for (int k = i * n; k < i * n + n; k++) {
                double gain = plane.metric(k) - held;
                if (gain >= least && gain * projections.speed(i) > most && plane.total() >= refusedUntil[k]) {
                    most = gain * projections.speed(i);
                    best = k;
                }
            }
        }
        return best;
    }

    /** Goes on to the next piece that may be a structure. */
    private void choose() {
        while (piece < count && !structures.isFull()) {
            piece++;
            from = pieces.start(piece);
            size = pieces.start(piece + 1) - from;
            letGo();
            if (size >= p.minEvents() && isNews()) {
                refinement.begin(events, pieces.events(), from, size, projections.vx(projection),
                    projections.vy(projection));
                stage = Stage.REFINING;
                return;
            }
        }
        finish();
    }

    /** Forgets events of the piece that the flow plane has let go in the meantime. */
    private void letGo() {
        while (size > 0 && !events.holds(pieces.events()[from])) {
            from++;
            size--;
        }
    }

    private void finish() {
        stage = Stage.IDLE;
        long total = plane.total();
        if (found) {
            nextLook = total;
        } else {
            int held = plane.count(projection / n);
            refusedUntil[projection] = total + Math.max(64, held / 4);
            // the more it cost the longer, but as long as much of what is held is as it was
            nextLook = total + Math.max(every, Math.min(held / 8, (fit.votes() - votesBefore) / VAIN_VOTES));
        }
    }

    /** Whether enough of the piece was not looked at in vain before, and is not of another structure by now. */
    private boolean isNews() {
        int old = 0;
        for (int a = from; a < from + size; a++) {
            int e = pieces.events()[a];
            if (events.wasRefused(projection / n, e) || events.isTakenOut(e)) {
                old++;
            }
        }
        return old <= (1 - NEWS) * size;
    }

    private void refine() {
        long before = fit.votes();
        if (!refinement.isOver()) {
            refinement.step();
        }
        budget.spend(fit.votes() - before);
        if (refinement.isOver()) {
            letGo();
            stage = Stage.CHOOSING;
            if (!refinement.isStructure()) {
                refuse();
            } else if (size >= p.minEvents() && !structures.isFull()) {
                track();
                beginToTakeOut();
            }
        }
    }

    private void refuse() {
        for (int a = from; a < from + size; a++) {
            events.refuse(projection / n, pieces.events()[a]);
        }
    }

    private void track() {
        takenSize = 0;
        if (!(pieces.isTexture(piece) || plane.isThinned()) || !trackWithSurroundings()) {
            trackPiece();
        }
    }

    private void trackPiece() {
        int last = pieces.events()[from + size - 1];
        Structures.Structure structure = structures.create(events.timeUs(last), refinement.vx(), refinement.vy());
        for (int a = from; a < from + size; a++) {
            hand(pieces.events()[a], structure);
        }
        structure.begin(events.timeUs(last));
        // those that came while it was refined, and would be a structure of their own, unless another has them
        for (int e = last + 1; e != events.head(); e++) {
            if (!events.isTakenOut(e) && structure.expects(events.x(e), events.y(e), events.timeUs(e),
                    events.sign(e))) {
                hand(e, structure);
            }
        }
    }

    /** Tracks a piece of texture with all that moves alike around it; returns whether anything does. */
    private boolean trackWithSurroundings() {
        long nowUs = plane.recent().newestUs();
        surroundings.begin(refinement.vx(), refinement.vy(), nowUs);
        for (int a = from; a < from + size; a++) {
            int e = pieces.events()[a];
            surroundings.addPlace(events.x(e), events.y(e), events.timeUs(e));
        }
        surroundings.spread(p.minEvents());
        if (!surroundings.isAny()) {
            return false;
        }
        Structures.Structure structure = structures.create(nowUs, refinement.vx(), refinement.vy());
        surroundings.hand(structure);
        structure.begin(nowUs);
        spreading.add(structure, nowUs);
        takeSurroundings();
        return true;
    }

    /** Lets a structure that is due begin to take over what moves alike around it by now; returns whether any does. */
    private boolean spreadsOn() {
        long nowUs = plane.recent().newestUs();
        Structures.Structure structure = spreading.due(nowUs);
        if (structure == null) {
            return false;
        }
        long before = fit.votes();
        surroundings.begin(structure, nowUs);
        surroundings.spreadAround(p.minEvents());
        budget.spend(fit.votes() - before);
        if (!surroundings.isAny()) {
            return false;
        }
        takenSize = 0;
        surroundings.hand(structure);
        takeSurroundings();
        beginToTakeOut();
        return true;
    }

    /** Takes what a structure has taken over with its surroundings out of the rings. */
    private void takeSurroundings() {
        for (int e = events.first(); e != events.head(); e++) {
            if (!events.isTakenOut(e) && surroundings.has(events.x(e), events.y(e), events.timeUs(e))) {
                take(e);
            }
        }
    }

    private void hand(int event, Structures.Structure structure) {
        structure.addPast(events.x(event), events.y(event), events.timeUs(event), events.sign(event));
        take(event);
    }

    private void take(int event) {
        if (takenSize == taken.length) {
            taken = Arrays.copyOf(taken, 2 * takenSize);
        }
        taken[takenSize++] = event;
    }

    private void beginToTakeOut() {
        budget.spend((long) takenSize * n);
        found = true;
        rings = 0;
        stage = Stage.TAKING_OUT;
    }

    /** Takes the events that a structure has got out of the next ring. */
    private void takeOut() {
        plane.takeOut(rings, taken, takenSize);
        budget.spend((long) takenSize * n / CHEAP_VOTES);
        rings++;
        if (rings == n) {
            stage = Stage.CHOOSING;
        }
    }

    /** Forgets the look that is under way, and what was looked at in vain. */
    public void reset() {
        Arrays.fill(refusedUntil, 0);
        stage = Stage.IDLE;
        nextLook = 0;
        budget.clear();
        spreading.clear();
    }
}
