package io.github.sofas.flow.track;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.motion.Motion;
import java.util.Arrays;

/**
 * Whether a structure is none of its own, but is made of parts of the structures around it. It is if its events meet at
 * least as often along the motions of others, in each tile along the one that suits the tile best, as along its own
 * motion.
 *
 * <p>Ours, because a structure that was found on two bodies at once has a motion between theirs, which is right for
 * neither. Also, the round outline of a body that turns shows no rotation, so that it never moves as the rest does. Of
 * all motions, a structure's own is the one along which its events meet most often. So others explain the events as
 * well only where they are the true ones.
 */
final class TakenOver {
    /** Fewest events of its own for the question to be asked: few events meet as often along any motion. */
    private static final int LEAST_EVENTS = 120;
    /**
     * Least shift of the ends of the window by which another motion differs, in px, where the structure reaches
     * farthest.
     */
    private static final double LEAST_APART_PX = 0.5;
    /** Greatest such shift of the structure's centre, in px: farther off are false tops of the metric. */
    private static final double MOST_APART_PX = 6;
    /** How many numbers there are to identify other structures. */
    private static final int NUMBERS = Byte.MAX_VALUE + 1;

    private final TiledEvents tiled;
    // of each tile: how often its events meet along a motion, and along the best of the others, and whose that one is
    private final long[] met;
    private final long[] best;
    private final byte[] owner;
    /** Number of events on the tiles of each of the other structures. */
    private final int[] share = new int[NUMBERS];
    private final Motion along = new Motion();
    private final Motion others = new Motion();
    private double radius;
    private double half;
    private LiveEvents live;
    /** Metric of the events along the structure's own motion. */
    private double own;
    /** Whether the motion of any other structure was tried. */
    private boolean isAsked;

    TakenOver(TiledEvents tiled) {
        this.tiled = tiled;
        met = new long[tiled.tiles()];
        best = new long[tiled.tiles()];
        owner = new byte[tiled.tiles()];
    }

    /** Bytes of its arrays, except those of the events. */
    static long bytes(SensorSize sensor) {
        return (2L * Long.BYTES + 1) * TiledEvents.tiles(sensor);
    }

    /**
     * Begins to ask about a structure.
     *
     * @param events of the structure
     * @param motion of the structure
     * @param reach its radius in px
     * @return whether there are enough events, and not more than can be measured at once
     */
    boolean begin(LiveEvents events, Motion motion, double reach) {
        live = events;
        isAsked = false;
        if (live.size() < LEAST_EVENTS || live.size() > Measurement.MOST_EVENTS) {
            return false;
        }
        half = (live.newestUs() - live.oldestUs()) * 0.5e-6;
        radius = reach;
        along.copyFrom(motion);
        along.moveReference(live.middleUs());
        return true;
    }

    /**
     * Tries the motion of another structure, unless it is about the same, or so far off that it may be a false top of
     * the metric.
     *
     * @param number by which the other structure is known, below 128
     */
    void offer(Motion motion, int number) {
        others.copyFrom(motion);
        others.moveReference(along.referenceUs);
        if (along.speedFrom(others, 0) * half > MOST_APART_PX
                || along.speedFrom(others, radius) * half < LEAST_APART_PX) {
            return;
        }
        if (!isAsked) {
            // most structures have no others around them, or none that move differently
            lay();
        }
        double reach = radius + Math.hypot(others.centreX - along.centreX, others.centreY - along.centreY);
        tiled.lay(others, reach);
        tiled.meet(0, 0, met);
        for (int t = 0; t < met.length; t++) {
            if (met[t] > best[t]) {
                best[t] = met[t];
                owner[t] = (byte) number;
            }
        }
    }

    private void lay() {
        isAsked = true;
        tiled.take(live, along, radius);
        own = tiled.meet(0, 0, met);
        Arrays.fill(best, Long.MIN_VALUE);
    }

    /** Whether the events meet as often along the motions of the others as along their own. */
    boolean isExplained() {
        if (!isAsked || tiled.size() < LEAST_EVENTS) {
            return false;
        }
        long sum = 0;
        for (int t = 0; t < best.length; t++) {
            sum += best[t];
        }
        return TiledEvents.metric(sum) >= own;
    }

    /** Number of the structure whose tiles have most of the events. */
    int heir() {
        Arrays.fill(share, 0);
        int heir = 0;
        for (int t = 0; t < owner.length; t++) {
            share[owner[t]] += tiled.events(t);
            heir = share[owner[t]] > share[heir] ? owner[t] : heir;
        }
        return heir;
    }

    /** Number of events that the question was asked with. */
    int size() {
        return tiled.size();
    }

    /** Index of the k-th of these events among the live events. */
    int index(int k) {
        return tiled.index(k);
    }

    /** Number of the structure along whose motion the tile of the k-th event meets most often. */
    int owner(int k) {
        return owner[tiled.tile(k)];
    }
}
