package io.github.sofas.flow.track;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.motion.Motion;
import java.util.Arrays;

/**
 * Whether a structure that seems to turn or grow is two bodies side by side that do neither. It is if its events meet
 * more often along two velocities, in each tile along the one that suits the tile better, than along its motion.
 *
 * <p>Ours, because some rotation and growth explain any two velocities side by side, and each measurement confirms them
 * as long as the two bodies touch. A body that does turn loses by two velocities: each is right on one line only. So a
 * structure that loses much is one body for certain, even if none of its parts shows that it turns, as with the shapes
 * of a poster.
 */
final class TwoBodies {
    /** Shift of the ends of the window by rotation and growth, in px, below which these are too little to explain. */
    private static final double LEAST_TURN_PX = 0.35;
    /** Fewest events of a body. */
    private static final int LEAST_EVENTS = 60;
    /** Standard deviations that the metric must gain by two velocities. */
    private static final double SHOWN_SIGMAS = 7;
    /**
     * Standard deviations that the metric must gain by a first step towards two velocities for these to be measured
     * exactly. Of the structures that prove to be two, 83 of 85 gain more.
     */
    private static final double HOPEFUL_SIGMAS = 1;
    /** Standard deviations that the metric must lose by two velocities for the structure to be clearly one body. */
    private static final double ONE_SIGMAS = 4;
    /**
     * Least and greatest distance, in px, by which the two velocities shift the ends of the window apart: farther off
     * are false tops of the metric.
     */
    private static final double LEAST_APART_PX = 0.5;
    private static final double MOST_APART_PX = 6;
    /** Lines through the middle by which the events are divided at first, one after the other. */
    private static final int LINES = 2;
    /** How often the velocities are measured, and each tile is given to the one that suits it better. */
    private static final int ROUNDS = 3;

    /** One of the two bodies, with its velocity relative to that of the structure's middle. */
    private static final class Body {
        private double vx;
        private double vy;
        /** How often the events of each tile meet along its velocity. */
        private final long[] met;

        Body(int tiles) {
            met = new long[tiles];
        }
    }

    /** The events that the structure alone claims. */
    private final TiledEvents tiled;
    private double middleX;
    private double middleY;
    private double radius;
    private double half;
    // of each tile: how often its events meet along the motion, and whether the second body has it
    private final long[] met;
    private final boolean[] isSecond;
    /** Number of events of each tile on one side of a line, less those on the other side. */
    private final int[] side;
    private final Body first;
    private final Body second;
    private int ofSecond;
    /** Whether the last measurement gave any tile to the other body. */
    private boolean changed;
    /** Motion of the structure in the middle of the window, and the same motion without rotation and growth. */
    private final Motion along = new Motion();
    private final Motion steady = new Motion();
    private final OwnVelocity own = new OwnVelocity();
    private boolean turns;
    private boolean isClearlyOne;
    // what was found last
    private final boolean[] isOfSmaller = new boolean[LiveEvents.CAPACITY];
    private final Motion smaller = new Motion();
    private final Motion larger = new Motion();

    TwoBodies(TiledEvents tiled) {
        this.tiled = tiled;
        int tiles = tiled.tiles();
        met = new long[tiles];
        isSecond = new boolean[tiles];
        side = new int[tiles];
        first = new Body(tiles);
        second = new Body(tiles);
    }

    /** Bytes of its arrays, except those of the events. */
    static long bytes(SensorSize sensor) {
        return LiveEvents.CAPACITY + (3L * Long.BYTES + Integer.BYTES + 1) * TiledEvents.tiles(sensor);
    }

    /** Whether a live event, by its index, belongs to the body with fewer events. */
    boolean isOfSmaller(int i) {
        return isOfSmaller[i];
    }

    /** Whether the structure examined last turned or grew enough for two velocities to look like it. */
    boolean turns() {
        return turns;
    }

    /** Whether the structure examined last turned or grew, and two velocities were clearly worse. */
    boolean isClearlyOne() {
        return isClearlyOne;
    }

    /** Motion of the body with fewer events, in the middle of the window of the live events. */
    Motion smaller() {
        return smaller;
    }

    /** Motion of the other one. */
    Motion larger() {
        return larger;
    }

    /**
     * Looks for two bodies.
     *
     * @param live the events of the structure, or those on some tiles, not all of one time
     * @param motion of the structure
     * @param reach radius of the structure in px
     * @return whether there are two; false for more events than can be measured at once
     */
    boolean find(LiveEvents live, Motion motion, double reach, MetricFit fit) {
        turns = false;
        isClearlyOne = false;
        long windowUs = live.newestUs() - live.oldestUs();
        half = windowUs * 0.5e-6;
        along.copyFrom(motion);
        if (live.size() > Measurement.MOST_EVENTS || turnPx(2 * reach) < LEAST_TURN_PX) {
            return false;
        }
        along.moveReference(live.middleUs());
        tiled.take(live, along, reach);
        findMiddle();
        if (tiled.size() < 2 * LEAST_EVENTS || turnPx(radius) < LEAST_TURN_PX) {
            return false;
        }
        double sd = MetricFit.sd(tiled.meet(0, 0, met));
        double most = SHOWN_SIGMAS * sd;
        steady.copyFrom(along);
        steady.moveCentre(middleX, middleY);
        steady.omega = 0;
        steady.alpha = 0;
        steady.growth = 0;
        steady.growthChange = 0;
        tiled.lay(steady, reach);
        boolean found = false;
        turns = true;
        isClearlyOne = true;
        for (int line = 0; line < LINES; line++) {
            divide(Math.PI * line / LINES);
            double gained = part(fit, HOPEFUL_SIGMAS * sd, most / 2);
            isClearlyOne &= gained < -ONE_SIGMAS * sd;
            if (gained > most && areTwo()) {
                most = gained;
                found = true;
                keep();
            }
        }
        return found;
    }

    /** Shift of the ends of the window by rotation and growth at a distance from the centre, in px. */
    private double turnPx(double distance) {
        return Math.hypot(along.omega, along.growth) * distance * half;
    }

    private void findMiddle() {
        double sumX = 0;
        double sumY = 0;
        double squares = 0;
        for (int k = 0; k < tiled.size(); k++) {
            sumX += tiled.x(k);
            sumY += tiled.y(k);
            squares += (double) tiled.x(k) * tiled.x(k) + (double) tiled.y(k) * tiled.y(k);
        }
        middleX = sumX / tiled.size();
        middleY = sumY / tiled.size();
        radius = Math.sqrt(Math.max(0, squares / tiled.size() - middleX * middleX - middleY * middleY));
    }

    /** Gives the tiles on one side of a line through the middle to one body, and the rest to the other. */
    private void divide(double angle) {
        double dirX = StrictMath.cos(angle);
        double dirY = StrictMath.sin(angle);
        Arrays.fill(side, 0);
        for (int k = 0; k < tiled.size(); k++) {
            side[tiled.tile(k)] += (tiled.x(k) - middleX) * dirX + (tiled.y(k) - middleY) * dirY > 0 ? 1 : -1;
        }
        for (int t = 0; t < side.length; t++) {
            isSecond[t] = side[t] > 0;
        }
        begin(first);
        begin(second);
    }

    /** Begins with the velocity that rotation and growth give to the middle of a body. */
    private void begin(Body body) {
        double sumX = 0;
        double sumY = 0;
        int its = 0;
        for (int k = 0; k < tiled.size(); k++) {
            if (isOf(body, k)) {
                sumX += tiled.x(k) - middleX;
                sumY += tiled.y(k) - middleY;
                its++;
            }
        }
        body.vx = (along.growth * sumX - along.omega * sumY) / Math.max(1, its);
        body.vy = (along.growth * sumY + along.omega * sumX) / Math.max(1, its);
    }

    private boolean isOf(Body body, int k) {
        return isSecond[tiled.tile(k)] == (body == second);
    }

    /**
     * Measures the two velocities, and which of them suits each tile better.
     *
     * @param hopeful gain of the metric by a first step above which they are measured exactly
     * @param promising gain of the metric by the first exact measurement above which it is worth while to continue
     * @return gain of the metric by the last measurement
     */
    private double part(MetricFit fit, double hopeful, double promising) {
        // for most structures that turn, a first step shows at little cost that two velocities are worse
        double gained = measure(fit, false);
        changed = true;
        for (int round = 0; round < ROUNDS && changed && gained > (round == 0 ? hopeful : promising); round++) {
            gained = measure(fit, true);
        }
        return gained;
    }

    private double measure(MetricFit fit, boolean exactly) {
        measure(first, fit, exactly);
        measure(second, fit, exactly);
        changed = false;
        ofSecond = 0;
        double gained = 0;
        for (int t = 0; t < met.length; t++) {
            boolean suits = second.met[t] > first.met[t];
            changed |= tiled.events(t) > 0 && suits != isSecond[t];
            isSecond[t] = suits;
            ofSecond += suits ? tiled.events(t) : 0;
            gained += TiledEvents.metric(Math.max(first.met[t], second.met[t]) - met[t]);
        }
        return gained;
    }

    private void measure(Body body, MetricFit fit, boolean exactly) {
        fit.clear();
        for (int k = 0; k < tiled.size(); k++) {
            if (isOf(body, k)) {
                float tau = tiled.tauS(k);
                fit.add((float) (tiled.x(k) - body.vx * tau), (float) (tiled.y(k) - body.vy * tau), tau, 0, 0,
                    tiled.sign(k));
            }
        }
        if (fit.size() >= Measurement.LEAST_EVENTS) {
            own.begin(fit, half);
            if (exactly) {
                own.goOn(fit, half);
            }
            body.vx += own.vx();
            body.vy += own.vy();
        }
        tiled.meet(body.vx, body.vy, body.met);
    }

    /**
     * Whether both bodies have enough events, and velocities that differ, but not by so much that one may be a false
     * top.
     */
    private boolean areTwo() {
        double apart = Math.hypot(second.vx - first.vx, second.vy - first.vy) * half;
        return Math.min(ofSecond, tiled.size() - ofSecond) >= LEAST_EVENTS && apart >= LEAST_APART_PX
            && apart <= MOST_APART_PX;
    }

    private void keep() {
        Body few = 2 * ofSecond <= tiled.size() ? second : first;
        Arrays.fill(isOfSmaller, false);
        for (int k = 0; k < tiled.size(); k++) {
            isOfSmaller[tiled.index(k)] = isOf(few, k);
        }
        take(few, smaller);
        take(few == second ? first : second, larger);
    }

    private void take(Body body, Motion motion) {
        motion.copyFrom(steady);
        motion.vx += body.vx;
        motion.vy += body.vy;
    }
}
