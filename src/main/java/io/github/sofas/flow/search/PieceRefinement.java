package io.github.sofas.flow.search;

import io.github.sofas.flow.SofasParameters;
import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.fit.VelocityTop;

/**
 * Refines the velocity of a piece of the flow plane: from that of its projection, fit by fit, to the top of the metric.
 * These are the paper's refining cycles (section Structure Detection). Each step makes one fit, so that labelling
 * continues in between.
 *
 * <p>Ours, because the metric rewards sliding an edge along itself at any speed while counts are small. A piece is
 * therefore a structure only if it has travelled enough to be distinguished from one that stands still, and if its
 * events meet often enough. Of velocities that are about equally good, the slowest is taken, the more readily the
 * slower it is. Texture shows its velocity along both axes, and by so many events that little travel is enough: its
 * metric only has to pass that at rest by more than chance. Most pieces are not structures, and are given up as soon as
 * they show it. Many have not travelled enough yet, and are sharper at rest than along their projection.
 */
final class PieceRefinement {
    /** Distance of the first projections, in px at the ends of the window. */
    private static final double FIRST_PX = 2;
    /** Most events of a piece that are fitted. */
    private static final int SAMPLE_EVENTS = 1000;
    /**
     * Share of the metric that the slowest velocity may lose and still be taken: an edge then gets its normal flow. The
     * share holds for a velocity that is hardly slower, and grows with the square of how many times slower it is. The
     * reason is two edges that are nearly parallel and move differently: they are sharp along one velocity, too, which
     * points far along both.
     */
    private static final double SLOWEST_WITHIN = 0.03;
    /**
     * Shares of the evidence below which a piece is given up after the first, second and third fit. Structures begin at
     * 0.5, and have 1 after the third.
     */
    private static final double[] HOPELESS = {0.4, 0.55, 0.75};
    /**
     * Standard deviations by which the metric must pass that at rest where a piece may still show its velocity, and
     * where it does. A metric of m has a standard deviation of sqrt(m). Ours, because many events show in 3 px of
     * travel what few events show in 6.
     */
    private static final double HOPEFUL_SIGMAS = 3;
    private static final double SHOWN_SIGMAS = 10;
    /**
     * Standard deviations by which the metric of any structure must pass that at rest: half of the pieces with fewer
     * have a wrong velocity.
     */
    private static final double LEAST_SIGMAS = 6;
    /** Least metric per event of a piece that shows its velocity by many events. */
    private static final double LEAST_DENSITY = 0.7;
    /** Longest window of a piece that shows its velocity by many events: as that of a region, and for its reason. */
    private static final double SHOWN_WITHIN_S = DenseRegions.LONGEST_US / 1e6;

    private enum Stage { BEST, SLOWEST, OVER }

    private final MetricFit fit;
    private final VelocityClimb climb;
    private SofasParameters.Search p;
    private Stage stage = Stage.OVER;
    private boolean structure;
    /** Whether the border of the sensor may cut off a part of the piece. */
    private boolean isAtBorder;
    /** Number of events of the piece, of which a sample is fitted. */
    private int size;
    private double window;
    /** Metric of the events where they are, that is at rest. */
    private double atRest;
    private double vx;
    private double vy;
    // what the first climb found
    private double bestX;
    private double bestY;
    private double bestMetric;

    PieceRefinement(MetricFit fit, SofasParameters.Search p) {
        this.fit = fit;
        climb = new VelocityClimb(fit);
        this.p = p;
    }

    /** Continues with other parameters. */
    void setParameters(SofasParameters.Search next) {
        p = next;
    }

    /**
     * Begins to refine a piece, given by some of the flow plane's events.
     *
     * @param numbers the numbers of the events in order of time; the piece has {@code count} of them, from the place
     *     {@code from} on
     * @param fromVx velocity to begin at, in px/s
     */
    void begin(FlowPlaneEvents events, int[] numbers, int from, int count, double fromVx, double fromVy) {
        size = count;
        long firstUs = events.timeUs(numbers[from]);
        long lastUs = events.timeUs(numbers[from + size - 1]);
        window = (lastUs - firstUs) * 1e-6;
        structure = false;
        if (window <= 0) {
            stage = Stage.OVER;
            return;
        }
        load(events, numbers, from, firstUs + (lastUs - firstUs) / 2);
        stage = Stage.BEST;
        climb.begin(fromVx, fromVy, window, FIRST_PX);
    }

    private void load(FlowPlaneEvents events, int[] numbers, int from, long referenceUs) {
        fit.clear();
        int want = Math.min(size, Math.min(fit.capacity(), SAMPLE_EVENTS));
        long stride = ((long) size << 16) / want;
        isAtBorder = false;
        for (int a = 0; a < want; a++) {
            int e = numbers[from + (int) (a * stride >> 16)];
            fit.add(events.x(e), events.y(e), (events.timeUs(e) - referenceUs) * 1e-6f, 0, 0, events.sign(e));
            isAtBorder |= fit.isAtBorder(events.x(e), events.y(e));
        }
        if (isAtBorder) {
            fit.cutOff(0, 0, window / 2);
        }
    }

    /** Whether no fit is left to make. */
    boolean isOver() {
        return stage == Stage.OVER;
    }

    /** Whether the piece is a structure, once the refinement is over. */
    boolean isStructure() {
        return structure;
    }

    /** Velocity of the structure in px/s. */
    double vx() {
        return vx;
    }

    double vy() {
        return vy;
    }

    /** Share of its metric that the structure loses along another velocity in px/s, once the refinement is over. */
    double shareLost(double otherVx, double otherVy) {
        return 1 - fit.metric(otherVx, otherVy) / fit.metric(vx, vy);
    }

    /** Standard deviation of the structure's metric, as a share of that metric. */
    double noiseShare() {
        double metric = fit.metric(vx, vy);
        return MetricFit.sd(metric) / metric;
    }

    /** Makes the next fit. */
    void step() {
        if (climb.fits() == 0 && stage == Stage.BEST) {
            atRest = fit.metric();
            if (fit.metric(climb.vx(), climb.vy()) < atRest) {
                stage = Stage.OVER;
                return;
            }
        }
        VelocityTop top = climb.step();
        vx = climb.vx();
        vy = climb.vy();
        if (stage == Stage.BEST && climb.fits() <= HOPELESS.length
                && density(top.metric()) < HOPELESS[climb.fits() - 1] * p.evidence()
                && sigmasOverRest(top.metric()) < HOPEFUL_SIGMAS) {
            stage = Stage.OVER;
        } else if (climb.hasArrived()) {
            arrive(top);
        }
    }

    private void arrive(VelocityTop top) {
        if (stage == Stage.SLOWEST) {
            stage = Stage.OVER;
            double square = vx * vx + vy * vy;
            double bestSquare = bestX * bestX + bestY * bestY;
            if (square > bestSquare
                    || (bestMetric - top.metric()) * square > SLOWEST_WITHIN * bestMetric * bestSquare) {
                vx = bestX;
                vy = bestY;
            } else {
                structure = isEvident(top);
            }
            return;
        }
        stage = Stage.OVER;
        structure = isEvident(top);
        double across = vx * top.axisX() + vy * top.axisY();
        double along = vy * top.axisX() - vx * top.axisY();
        if (structure && Math.abs(along) > 0.1 * Math.abs(across)) {
            // seek the slowest velocity that is about as good: the one without the part along the edge
            stage = Stage.SLOWEST;
            bestX = vx;
            bestY = vy;
            bestMetric = top.metric();
            climb.begin(across * top.axisX(), across * top.axisY(), window, FIRST_PX);
        }
    }

    /** Whether the last fit shows a structure, and not what chance or an edge that slides along itself would give. */
    private boolean isEvident(VelocityTop top) {
        double metric = isAtBorder ? fit.metricAsSeen(vx, vy) : top.metric();
        // where the border counts, the climb may have led from rest to a motion that soon leaves the sensor
        return sigmasOverRest(metric) >= LEAST_SIGMAS
            && (hasTravelled(top) && density(metric) >= p.evidence() || isShown(metric));
    }

    /** Whether the piece, as fitted last, has travelled enough to be distinguished from one that stands still. */
    private boolean hasTravelled(VelocityTop top) {
        // travel counts where it is visible: in the directions in which standing still would lose metric
        double loss = top.lossXx() * vx * vx + 2 * top.lossXy() * vx * vy + top.lossYy() * vy * vy;
        double travelPx = Math.sqrt(Math.max(0, loss / top.bestLoss())) * window;
        return travelPx > 0.6 * Projections.TRAVEL_PX;
    }

    /** Whether the metric passes that at rest by more than chance, and the velocity is known along both axes. */
    private boolean isShown(double metric) {
        return window < SHOWN_WITHIN_S && sigmasOverRest(metric) > SHOWN_SIGMAS && density(metric) > LEAST_DENSITY
            && climb.isKnown();
    }

    private double sigmasOverRest(double metric) {
        return (metric - Math.max(0, atRest)) / MetricFit.sd(metric);
    }

    /** Metric per event of the whole piece. In a thinned sample, events meet less often in proportion. */
    private double density(double metric) {
        return metric / fit.size() * size / fit.size();
    }
}
