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
    private static final int EVERY = 32;
    private static final int EVERY_CELLS = 512;
    /** Standard deviations by which a metric must pass what chance gives. */
    private static final double CHANCE_SIGMAS = 6;
    /** Share of its events that a piece must have that were not looked at in vain before, and that no structure has. */
    private static final double NEWS = 0.1;
    /** Votes of the flow plane, and cells looked through, that cost as much as one vote of a fit. */
    private static final int CHEAP_VOTES = 2;
    private static final int CHEAP_CELLS = 4;

    /** Votes that a look in vain may give for each unmatched event until the next. */
    private static final int VAIN_VOTES = 30;

    private enum Stage { IDLE, CHOOSING, REFINING, TAKING_OVER, TAKING_OUT }

    private final FlowPlane plane;
    private final Projections projections;
    private final FlowPlaneEvents events;
    private final int n;
    private final int every;
    private final long[] refusedUntil;
    private final Pieces pieces;
    private final PieceRefinement refinement;
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

    // the look that is under way: votes of the search before it, projection, its pieces, the one that is looked at
    private long votesBefore;
    private int projection;
    private boolean found;
    private int piece;
    private int count;
    private int from;
    private int size;

    /** The most bytes that the arrays of a search and of its flow plane take, but for those of its fit. */
    public static long mostBytes(SensorSize sensor, SofasParameters.Search p) {
        return FlowPlane.mostBytes(sensor, p) + Pieces.mostBytes(Projections.cells(sensor))
            + Surroundings.bytes(sensor) + Recognition.BYTES;
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
        recognition = new Recognition(structures, events);
        taken = new TakenEvents(plane);
        takingOver = new TakingOver(plane, fit, structures, taken, budget);
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
     * @param nowUs time of the event
     */
    public void run(long measuringVotes, long nowUs) {
        run(measuringVotes, nowUs, true);
    }

    /**
     * The same.
     *
     * @param spreads whether structures that are tracked may look around themselves, and be shown their parts; not
     *     while others track them
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
     * Lets a structure that is due begin to look around itself, unless a look is under way, and hands to one that is
     * tracked some of what it has found there. Shows structures the parts that they were recognised by, and looks what
     * is tracked by now.
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

    /** Whether a look is under way or due, and can go on. */
    private boolean isBusy() {
        if (stage == Stage.IDLE) {
            return plane.total() >= nextLook || mayBeSpread && takingOver.isAnyDue();
        }
        return stage != Stage.TAKING_OVER || mayBeSpread || !takingOver.waits();
    }

    private void work() {
        switch (stage) {
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
            refusedUntil[projection] = total + Math.max(64, held / 16);
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
                recognise();
            }
        }
    }

    /** Has the piece shown to the structure that it is a part of; else it is a structure of its own. */
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
        // those that came while it was refined, and would be a structure of their own, unless another has them
        for (int e = last + 1; e != events.head(); e++) {
            if (!events.isTakenOut(e) && structure.expects(events.x(e), events.y(e), events.timeUs(e),
                    events.sign(e))) {
                hand(e, structure);
            }
        }
        budget.spend((long) taken.size() * n);
        beginToTakeOut();
    }

    /** Lets a structure that is due begin to look around itself; returns whether any does. */
    private boolean spreadsOn() {
        boolean any = takingOver.beginWithDue();
        if (any) {
            stage = Stage.TAKING_OVER;
        }
        return any;
    }

    /** Goes on to hand its surroundings to a structure; to a piece that has none, its own events. */
    private void takeOver() {
        takingOver.goOn(p.minEvents());
        if (!takingOver.isOver()) {
            return;
        }
        if (takingOver.hasHanded()) {
            beginToTakeOut();
        } else if (takingOver.isOfTracked()) {
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

    /** Takes some of the events that a structure has got out of the next ring. */
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
