package io.github.sofas.flow.track;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.motion.Motion;
import java.util.Arrays;

/**
 * Whether a structure is none of its own, but made of parts of those around it: whether its events meet at least as
 * often along the motions of others, in each tile along the one that suits it best, as along its own.
 *
 * <p>Ours, because what was found on two bodies at once has a motion between theirs, which is right for neither, and
 * the round outline of what turns shows no rotation, so that it never moves as the rest does. Of all motions its own is
 * the one by which its events meet most often; so others explain them as well only where they are the true ones.
 */
final class TakenOver {
    /** Fewest events of its own that it is asked with: few meet as often by any motion. */
    private static final int LEAST_EVENTS = 120;
    /** By what another motion shifts the ends of the window, in px, at least, where it reaches farthest. */
    private static final double LEAST_APART_PX = 0.5;
    /** The same of its centre, at most: farther off are false tops. */
    private static final double MOST_APART_PX = 6;
    /** Numbers by which others are known. */
    private static final int NUMBERS = Byte.MAX_VALUE + 1;

    private final TiledEvents tiled;
    // of each tile: how often its events meet along a motion, along the best of the others, and whose that is
    private final long[] met;
    private final long[] best;
    private final byte[] owner;
    /** How many events the tiles of each of the others have. */
    private final int[] share = new int[NUMBERS];
    private final Motion along = new Motion();
    private final Motion others = new Motion();
    private double radius;
    private double half;
    private LiveEvents live;
    /** Metric of the events along their own motion. */
    private double own;
    /** Whether it was asked with the motion of any other. */
    private boolean isAsked;

    TakenOver(TiledEvents tiled) {
        this.tiled = tiled;
        met = new long[tiled.tiles()];
        best = new long[tiled.tiles()];
        owner = new byte[tiled.tiles()];
    }

    /** Bytes of its arrays, but for those of the events. */
    static long bytes(SensorSize sensor) {
        return (2L * Long.BYTES + 1) * TiledEvents.tiles(sensor);
    }

    /**
     * Begins to ask.
     *
     * @param events of the structure
     * @param motion of the structure
     * @param reach its radius in px
     * @return whether its events are enough, and not more than can be measured at once
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
     * Asks with the motion of another structure, unless that is about the same, or so far off that it may be a false
     * top.
     *
     * @param number by which it is known, below 128
     */
    void offer(Motion motion, int number) {
        others.copyFrom(motion);
        others.moveReference(along.referenceUs);
        if (along.speedFrom(others, 0) * half > MOST_APART_PX
                || along.speedFrom(others, radius) * half < LEAST_APART_PX) {
            return;
        }
        if (!isAsked) {
            // most structures have no others about them, or none that move otherwise
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

    /** Whether its events meet as often along the motions of the others. */
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

    /** How many events it was asked with. */
    int size() {
        return tiled.size();
    }

    /** Index of the k-th of them among the live events. */
    int index(int k) {
        return tiled.index(k);
    }

    /** Number of the structure along whose motion the tile of the k-th event meets most often. */
    int owner(int k) {
        return owner[tiled.tile(k)];
    }
}
