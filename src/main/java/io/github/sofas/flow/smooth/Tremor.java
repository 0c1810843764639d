package io.github.sofas.flow.smooth;

import io.github.sofas.flow.motion.Motion;
import java.util.Arrays;
import java.util.List;

/**
 * How fast a trembling camera is at each time, as a multiple of the speed of the path of what fills its picture. The
 * events show this as an odometer does: a structure gives about as many of them per px of travel at any speed.
 *
 * <p>Ours, because a hand trembles about ten times per second. That shifts the picture by less than a tenth of a px,
 * which no alignment shows, but changes the speed by a tenth or more.
 *
 * <p>Most events must have one label, so that nothing hides it or enters the picture beside it. It must give many
 * events, and their number per px must vary more from moment to moment than by chance, and than the usual number does.
 */
final class Tremor {
    /** Time and fewest events, on both sides of a moment, that show how many come there: no hand trembles faster. */
    private static final long NEAR_US = 10_000;
    private static final int NEAR_EVENTS = 2000;
    /** Most time and travel, on either side, that show how many come usually: no hand trembles much slower. */
    private static final long FAR_US = 100_000;
    private static final double FAR_PX = 5;
    /** Logarithm of the greatest pace of a tremor, and of the inverse of the least. */
    private static final double MOST = 0.5;
    /** Most events of other labels, as a share of its own. */
    private static final double OTHERS = 0.2;

    private final EventWindow window;
    private final Labels labels;
    private final long blockUs;
    private final Motion motion = new Motion();
    /** The label that may tremble; 0 if none may. */
    private int label;
    private int own;
    private int others;
    private long sliceFromUs;
    private long fromUs;
    private int blocks;
    /** First and last block with events, in which these begin and end. */
    private int first;
    private int last;
    // by block of time: events and travel before each, logarithms of the pace and of the usual events per px, what
    // variance the pace has by chance, how many blocks on either side show the usual number (0 if nothing shows), and
    // the factor
    private final double[] events;
    private final double[] travel;
    private final double[] pace;
    private final double[] perPx;
    private final double[] chance;
    private final int[] far;
    private final float[] factor;

    /**
     * Makes one.
     *
     * @param blockUs duration of a block in µs
     * @param mostBlocks of all slices together
     */
    Tremor(EventWindow window, Labels labels, long blockUs, int mostBlocks) {
        this.window = window;
        this.labels = labels;
        this.blockUs = blockUs;
        events = new double[mostBlocks + 1];
        travel = new double[mostBlocks + 1];
        pace = new double[mostBlocks];
        perPx = new double[mostBlocks];
        chance = new double[mostBlocks];
        far = new int[mostBlocks];
        factor = new float[mostBlocks];
    }

    /** Bytes of its arrays. */
    static long bytes(int mostBlocks) {
        return mostBlocks * (5L * Double.BYTES + Integer.BYTES + Float.BYTES);
    }

    /** What the velocity of an event of the slice that was looked at last is to be multiplied by. */
    float factor(int itsLabel, long us) {
        // an event may have the time of the slice before, which was full
        return label != 0 && itsLabel == label ? factor[block(Math.max(us, sliceFromUs))] : 1;
    }

    private int block(long us) {
        return (int) Math.max(0, Math.min(blocks - 1, (us - fromUs) / blockUs));
    }

    /**
     * Looks how the picture trembles in a slice.
     *
     * @param path that of most events of the slice; null if it has none
     * @param slices the slices around it, in order
     */
    void look(SegmentPath path, List<Slice> slices, Slice slice) {
        label = 0;
        if (path == null || !path.isMeasured()) {
            return;
        }
        sliceFromUs = slice.fromUs;
        fromUs = slices.get(0).fromUs;
        blocks = (int) ((slices.get(slices.size() - 1).untilUs - 1 - fromUs) / blockUs) + 1;
        int its = labels.ofPath(path.id());
        if (!count(its, slices, slice)) {
            return;
        }
        label = its;
        follow(path);
        for (int block = 0; block < blocks; block++) {
            compare(block);
        }
        for (int block = block(slice.fromUs); block <= block(slice.untilUs - 1); block++) {
            double belief = belief(block);
            factor[block] = belief > 0 ? (float) StrictMath.exp(belief * pace[block]) : 1;
        }
    }

    /** Counts the events of a label before each block; false if they are few, or others have too many. */
    private boolean count(int its, List<Slice> slices, Slice slice) {
        Arrays.fill(events, 0, blocks + 1, 0);
        own = 0;
        others = 0;
        count(its, slice);
        for (int k = 0; k < slices.size() && others <= OTHERS * own; k++) {
            if (slices.get(k) != slice) {
                count(its, slices.get(k));
            }
        }
        first = blocks;
        for (int block = 0; block < blocks; block++) {
            if (events[block + 1] > 0) {
                first = Math.min(first, block);
                last = block;
            }
            events[block + 1] += events[block];
        }
        return others <= OTHERS * own && own >= NEAR_EVENTS;
    }

    private void count(int its, Slice slice) {
        for (long i = slice.from; i < slice.until; i++) {
            int k = window.at(i);
            if (window.label[k] == its) {
                own++;
                events[block(window.timeUs[k]) + 1]++;
            } else if (window.label[k] != 0) {
                others++;
            }
        }
    }

    /** Sums up the travel along a path before each block. */
    private void follow(SegmentPath path) {
        for (int block = 0; block < blocks; block++) {
            path.at(fromUs + block * blockUs + blockUs / 2, motion);
            travel[block + 1] = travel[block] + path.speed(motion) * blockUs * 1e-6;
        }
    }

    /** Compares the number of events per px about a block with the usual one. */
    private void compare(int block) {
        far[block] = 0;
        double px = travel[block + 1] - travel[block];
        int known = Math.min(block - first, last - block) - 1;
        int most = (int) Math.min(known, Math.min(FAR_PX / px, (double) FAR_US / blockUs));
        int near = (int) Math.max(1, NEAR_US / blockUs);
        while (near < most && sum(events, block, near) < NEAR_EVENTS) {
            near++;
        }
        if (most < 2 * near) {
            return;
        }
        double usual = sum(events, block, most) / sum(travel, block, most);
        pace[block] = StrictMath.log(sum(events, block, near) / sum(travel, block, near) / usual);
        perPx[block] = StrictMath.log(usual);
        chance[block] = 1 / sum(events, block, near);
        far[block] = most;
    }

    /** Sum over a block and so many on either side. */
    private static double sum(double[] before, int block, int side) {
        return before[block + side + 1] - before[block - side];
    }

    /** By how much the pace in a block is believed, 0 to 1: by the share of its variance around it that is its own. */
    private double belief(int block) {
        double paces = 0;
        double chances = 0;
        double densities = 0;
        double squares = 0;
        int n = 0;
        for (int k = block - far[block]; k <= block + far[block]; k++) {
            if (far[k] > 0) {
                n++;
                paces += pace[k] * pace[k];
                chances += chance[k];
                densities += perPx[k];
                squares += perPx[k] * perPx[k];
                if (Math.abs(pace[k]) > MOST) {
                    return 0;
                }
            }
        }
        return paces > 0 ? Math.max(0, 1 - (chances + squares - densities * densities / n) / paces) : 0;
    }
}
