package io.github.sofas.flow.search;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.SofasParameters;
import io.github.sofas.flow.fit.MetricFit;
import java.util.Arrays;

/**
 * Finds structures in the flow plane. A look takes the best projection, finds its pieces (paper, section Flow Plane),
 * and refines the velocity of each piece. A piece that is a structure becomes a track plane, unless it is recognised as
 * a part of a tracked structure. Each piece is refined by itself, because several structures may roughly share the best
 * projection. The tracking merges pieces of one structure.
 *
 * <p>Ours: a look takes up to a thousand times as long as labelling an event. It is therefore made in small steps
 * between the events that come in the meantime, so that no event waits for a whole look.
 */
public final class StructureSearch {
    /** Unmatched events between two looks, and cells of an accumulator per such event, where these give more events. */
    private static final int EVERY = 32;
    private static final int EVERY_CELLS = 512;
    /** Standard deviations by which a metric must pass that of chance. */
    private static final double CHANCE_SIGMAS = 6;
    /**
     * Least share of new events in a piece: those that were not looked at in vain before, and that no structure has.
     */
    private static final double NEWS = 0.1;
    /** Votes of the flow plane, and cells looked through, that cost as much as one vote of a fit. */
    private static final int CHEAP_VOTES = 2;
    private static final int CHEAP_CELLS = 4;

    /** Votes that a look in vain may have cost per unmatched event until the next look. */
    private static final int VAIN_VOTES = 30;

    private enum Stage { IDLE, MEASURING_REGION, CHOOSING, REFINING, TAKING_OVER, TAKING_OUT }

    private final FlowPlane plane;
    private final Projections projections;
    private final FlowPlaneEvents events;
    private final int n;
    private final int every;
    private final long[] refusedUntil;
    private final Pieces pieces;
    private final PieceRefinement refinement;
    private final RegionRefinement ofRegion;
    private final Recognition recognition;
    private final TakingOver takingOver;
    private final TakenEvents taken;
    private final MetricFit fit;
    private final Structures structures;
    private final VoteBudget budget;
    private SofasParameters.Search p;

    private Stage stage = Stage.IDLE;
    private boolean mayBeSpread;
    private long nextLook;

    // the look under way: votes of the fit before, its projection, whether a structure was found, and the current piece
    private long votesBefore;
    private int projection;
    private boolean found;
    private int piece;
    private int count;
    private int from;
    private int size;

    /** Most bytes of the arrays of a search and of its flow plane, except those of the fit. */
    public static long mostBytes(SensorSize sensor, SofasParameters.Search p) {
        return FlowPlane.mostBytes(sensor, p) + Pieces.mostBytes(Projections.cells(sensor))
            + Surroundings.bytes(sensor) + Recognition.BYTES;
    }

    /**
     * Creates a search in a flow plane, which hands the structures that it finds to {@code structures}.
     *
     * @param measuringVotes votes that the measurements of track planes gave so far, for which the search owes nothing
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
        ofRegion = new RegionRefinement(plane.regions(), plane.recent(), fit);
        recognition = new Recognition(structures, events);
        taken = new TakenEvents(plane);
        takingOver = new TakingOver(plane, fit, structures, taken, budget);
    }

    /** Continues with other parameters, which must leave the flow plane as it is. */
    public void setParameters(SofasParameters.Search next) {
        p = next;
        refinement.setParameters(next);
    }

    /**
     * Searches for structures as far as is due with another event.
     *
     * @param measuringVotes votes that the measurements of track planes gave so far
     * @param nowUs time of the event
     */
    public void run(long measuringVotes, long nowUs) {
        run(measuringVotes, nowUs, true);
    }

    /**
     * Searches for structures as {@link #run(long, long)} does.
     *
     * @param spreads whether tracked structures may look around themselves, and be shown their parts; false while
     *     another thread tracks them
     */
    void run(long measuringVotes, long nowUs, boolean spreads) {
        mayBeSpread = spreads;
        if (spreads && recognition.waits()) {
            recognition.show(plane.recent().newestUs());
        }
        budget.earn(measuringVotes, nowUs);
        if (stage == Stage.TAKING_OVER) {
            takingOver.earn();
        }
        while (budget.isLeft() && isBusy()) {
            work();
        }
    }

    /**
     * Lets a structure that is due begin to look around itself, unless a look is under way, and hands to a tracked
     * structure some of the events that it found around itself. Shows structures the parts that were recognised as
     * theirs, and looks anew which structures are tracked.
     */
    void spread() {
        long nowUs = plane.recent().newestUs();
        recognition.show(nowUs);
        recognition.look(nowUs);
        if (stage == Stage.IDLE) {
            spreadsOn();
        }
        if (stage == Stage.TAKING_OVER) {
            takingOver.handToTracked();
        }
    }

    /** Whether a look is under way or due, and can continue. */
    private boolean isBusy() {
        if (stage == Stage.IDLE) {
            return plane.total() >= nextLook || ofRegion.isAnyDue() || mayBeSpread && takingOver.isAnyDue();
        }
        return stage != Stage.TAKING_OVER || mayBeSpread || !takingOver.waits();
    }

    private void work() {
        switch (stage) {
            case MEASURING_REGION:
                measureRegion();
                break;
            case CHOOSING:
                choose();
                break;
            case REFINING:
                refine();
                break;
            case TAKING_OVER:
                takeOver();
                break;
            case TAKING_OUT:
                takeOut();
                break;
            default:
                look();
        }
    }

    /** Begins to look at a dense region, or else at the best projection, if there is one. */
    private void look() {
        if (mayBeSpread && spreadsOn()) {
            return;
        }
        if (ofRegion.isAnyDue()) {
            budget.spend(ofRegion.begin() / Surroundings.EVENTS_PER_VOTE);
            stage = Stage.MEASURING_REGION;
        } else if (plane.total() >= nextLook) {
            lookAtProjection();
        }
    }

    private void measureRegion() {
        long before = fit.votes();
        if (!ofRegion.isOver()) {
            ofRegion.step();
        }
        budget.spend(fit.votes() - before);
        if (ofRegion.isOver()) {
            stage = Stage.IDLE;
            if (ofRegion.isStructure() && !structures.isFull()) {
                takingOver.begin(ofRegion);
                stage = Stage.TAKING_OVER;
            }
        }
    }

    private void lookAtProjection() {
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
     * The projection whose metric gains most over chance per unit of time; -1 if none gains enough. By chance, signed
     * votes at random places give a metric of one per event. The gain counts per time, because slow projections hold
     * events longer.
     */
    private int best() {
        int best = -1;
        double most = 0;
        for (int i = 0; i < n; i++) {
            if (plane.end(i) - plane.oldest(i) < p.minEvents()) {
                // its votes may wait
                continue;
            }
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

    /** Advances to the next piece that may be a structure. */
    private void choose() {
        while (piece < count && !structures.isFull()) {
            piece++;
            from = pieces.start(piece);
            size = pieces.start(piece + 1) - from;
            letGo();
            if (size >= p.minEvents() && hasNewEvents()) {
                refinement.begin(events, pieces.events(), from, size, projections.vx(projection),
                    projections.vy(projection));
                stage = Stage.REFINING;
                return;
            }
        }
        finish();
    }

    /** Forgets events of the piece that the flow plane has released in the meantime. */
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
            refusedUntil[projection] = total + Math.max(64, held / 16);
            // wait the longer the more the look cost, but only while much of what is held is unchanged
            nextLook = total + Math.max(every, Math.min(held / 8, (fit.votes() - votesBefore) / VAIN_VOTES));
        }
    }

    /**
     * Whether enough events of the piece are new: not looked at in vain before, and not taken by another structure by
     * now.
     */
    private boolean hasNewEvents() {
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
                recognise();
            }
        }
    }

    /**
     * Gives the piece to the structure of which it is a part; a piece that is no part is tracked as a structure of its
     * own.
     */
    private void recognise() {
        if (mayBeSpread) {
            recognition.look(plane.recent().newestUs());
        }
        long before = fit.votes();
        int known = recognition.structureOf(pieces.events(), from, size, refinement);
        budget.spend(fit.votes() - before);
        if (known == 0) {
            track();
            return;
        }
        taken.clear();
        for (int a = from; a < from + size; a++) {
            recognition.give(known, pieces.events()[a]);
            taken.add(pieces.events()[a]);
        }
        budget.spend((long) taken.size() * n);
        beginToTakeOut();
    }

    private void refuse() {
        for (int a = from; a < from + size; a++) {
            events.refuse(projection / n, pieces.events()[a]);
        }
    }

    private void track() {
        if (pieces.isTexture(piece) || plane.isThinned()) {
            takingOver.begin(refinement.vx(), refinement.vy());
            for (int a = from; a < from + size; a++) {
                takingOver.addPlace(pieces.events()[a]);
            }
            stage = Stage.TAKING_OVER;
        } else {
            trackPiece();
        }
    }

    private void trackPiece() {
        taken.clear();
        int last = pieces.events()[from + size - 1];
        Structures.Structure structure = structures.create(events.timeUs(last), refinement.vx(), refinement.vy());
        for (int a = from; a < from + size; a++) {
            hand(pieces.events()[a], structure);
        }
        structure.begin(events.timeUs(last));
        // also events that came during the refinement: they would be a structure of their own, unless another has them
        for (int e = last + 1; e != events.head(); e++) {
            if (!events.isTakenOut(e) && structure.expects(events.x(e), events.y(e), events.timeUs(e),
                    events.sign(e))) {
                hand(e, structure);
            }
        }
        budget.spend((long) taken.size() * n);
        beginToTakeOut();
    }

    /** Lets a structure that is due begin to look around itself; returns whether one does. */
    private boolean spreadsOn() {
        boolean any = takingOver.beginWithDue();
        if (any) {
            stage = Stage.TAKING_OVER;
        }
        return any;
    }

    /**
     * Continues to hand a structure its surroundings. A piece that has none becomes a structure with its own events
     * alone.
     */
    private void takeOver() {
        takingOver.goOn(p.minEvents());
        if (!takingOver.isOver()) {
            return;
        }
        if (takingOver.hasHanded()) {
            beginToTakeOut();
        } else if (!takingOver.isOfPiece()) {
            stage = Stage.IDLE;
        } else {
            stage = Stage.CHOOSING;
            letGo();
            if (size >= p.minEvents() && !structures.isFull()) {
                trackPiece();
            }
        }
    }

    private void hand(int event, Structures.Structure structure) {
        structure.addPast(events.x(event), events.y(event), events.timeUs(event), events.sign(event));
        taken.add(event);
    }

    private void beginToTakeOut() {
        found = true;
        stage = Stage.TAKING_OUT;
    }

    /** Takes some of the events that a structure has received out of the next ring. */
    private void takeOut() {
        budget.spend((long) taken.takeOut() * n / CHEAP_VOTES);
        if (taken.isOver()) {
            stage = Stage.CHOOSING;
        }
    }

    /** Forgets the look that is under way, and what was looked at in vain. */
    public void reset() {
        Arrays.fill(refusedUntil, 0);
        stage = Stage.IDLE;
        nextLook = 0;
        budget.clear();
        takingOver.clear();
        recognition.clear();
    }
}
