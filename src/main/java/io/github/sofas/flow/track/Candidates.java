package io.github.sofas.flow.track;

import java.util.Arrays;

/**
 * The track planes that may have an event, and whose it is: that of the nearest contour, or the one that remembers its
 * place where it lies on none, unless the edge came farther along the motion of another.
 *
 * <p>Ours. A contour has what its plane was given before, so that of structures that overlap the one that has been
 * given more gets more; {@link PixelHistory} knows the events of late whatever they were taken for. Edges that come as
 * far along several motions, as those of the pieces that a body is found in, stay with their piece. What comes out from
 * behind a body is on no contour: the body would remember its place, follow it, and be carried away. Nor is what enters
 * the picture: its trace is cut off by the border, so that any other had a longer one by chance, and was carried along
 * the border. Between a wall and what moves before it, {@link Ground} decides.
 */
final class Candidates {
    /** Close support decides which contour is nearest, and support by all cells around it where that is the same. */
    private static final int CLOSE_WEIGHT = 4 * ContourCells.SIXTEENTHS;
    /** Score of the second contour, as a share of the nearest, that hides the velocity: crossing objects pull. */
    private static final double SHARED_SCORE = 0.5;
    /** Support below this many thresholds is weak. */
    private static final int WEAK = 2;
    /** Least trace of a remembered event that another plane may have: noise has none. */
    private static final int LEAST_TRACE = 2;
    /**
     * Standard deviations by which the trace of a remembered event must pass that of noise; of one that is not, for
     * which many motions are asked.
     */
    private static final double REMEMBERED_SIGMAS = 3;
    private static final double OTHER_SIGMAS = 5;
    /** What noise must be able to have for a remembered event that no other plane may have to need as much. */
    private static final int DARK_TRACE = 5;
    /** What its trace must be longer by along the motion of a plane that does not remember it. */
    private static final int CLEAR_TRACE = 2 * PixelHistory.ON_THE_PIXEL;
    /** Live events of a texture, at least: where one that has fewer enters, most of the events are not its own. */
    private static final int LEAST_OF_TEXTURE = 2000;
    /** Trace by which an edge came along a motion beyond doubt, also where all of a wall fires around it. */
    private static final int SURE_TRACE = 6 * PixelHistory.ON_THE_PIXEL;

    /** Those that expect it; as long as none does, all that were offered it. */
    private TrackPlane[] planes = new TrackPlane[16];
    private int size;
    private TrackPlane nearest;
    /** Scores of the nearest contour and of the second. */
    private int most;
    private int second;
    // of the plane that has the event
    private TrackPlane best;
    private int support;
    private int closeSupport;
    private boolean isAppearing;
    private final Ground ground = new Ground();

    /** Begins with an event. */
    void clear() {
        size = 0;
        best = null;
        isAppearing = false;
        ground.clear();
        nearest = null;
        most = Integer.MIN_VALUE;
        second = Integer.MIN_VALUE;
    }

    /** Considers a plane in whose box the event lies; it expects the event if that lies on its contour. */
    void offer(TrackPlane plane, int x, int y, long timeUs, int polarity) {
        ground.offer(plane);
        int its = plane.support(x, y, timeUs, polarity);
        if (its < plane.threshold()) {
            if (nearest == null) {
                add(plane);
            }
            return;
        }
        if (nearest == null) {
            size = 0;
        }
        add(plane);
        int close = plane.closeSupport(polarity);
        int score = close * CLOSE_WEIGHT + its;
        if (score > most) {
            second = most;
            most = score;
            nearest = plane;
            support = its;
            closeSupport = close;
        } else if (score > second) {
            second = score;
        }
    }

    private void add(TrackPlane plane) {
        if (size == planes.length) {
            planes = Arrays.copyOf(planes, 2 * size);
        }
        planes[size++] = plane;
    }

    /** The plane that the event belongs to; null where none expects it. */
    TrackPlane best(PixelHistory history, int x, int y, long timeUs, int polarity) {
        best = nearest;
        if (nearest != null && size > 1) {
            int trace = history.trace(x, y, timeUs, polarity, nearest.motion());
            best = farther(trace + PixelHistory.ON_THE_PIXEL, nearest, history, x, y, timeUs, polarity);
        }
        if (best != null) {
            best = beforeGround(history, x, y, timeUs, polarity);
        }
        if (best != nearest) {
            support = best.support(x, y, timeUs, polarity);
            isAppearing = support < best.threshold();
            if (!isAppearing) {
                closeSupport = best.closeSupport(polarity);
            }
        }
        return best;
    }

    /** The plane that has the event, or the ground that it moves before, or a body before it if that is the ground. */
    private TrackPlane beforeGround(PixelHistory history, int x, int y, long timeUs, int polarity) {
        if (best == ground.plane()) {
            TrackPlane body = farther(-1, best, history, x, y, timeUs, polarity);
            return ground.yields(body, history, x, y, timeUs, polarity) ? body : best;
        }
        return ground.has(best, history, x, y, timeUs, polarity) ? ground.plane() : best;
    }

    /**
     * The plane that has the event where none expects it: the texture that enters the picture there, unless the edge
     * came along the motion of another beyond doubt; or the ground, where that comes out from behind a body.
     *
     * @param remembering the plane that remembers its place; null for none
     * @param noise how many noise events a pixel gives of either polarity, per µs
     * @return null where its edge came along no motion, or no farther than noise would
     */
    TrackPlane unexpected(TrackPlane remembering, PixelHistory history, double noise, int x, int y, long timeUs,
                          int polarity) {
        TrackPlane its = byTrace(remembering, history, noise, x, y, timeUs, polarity);
        TrackPlane appearing = appearing(its, history, x, y, timeUs, polarity);
        if (appearing == null) {
            return its;
        }
        isAppearing = true;
        // it is the event whose support was asked for last
        appearing.support(x, y, timeUs, polarity);
        return appearing;
    }

    /** The texture that comes into sight where another plane would have the event, or none; null for none. */
    private TrackPlane appearing(TrackPlane other, PixelHistory history, int x, int y, long timeUs, int polarity) {
        TrackPlane entering = history.isNearBorder(x, y) ? entering(history, x, y, timeUs) : null;
        if (other == null) {
            return entering;
        }
        if (entering != null) {
            return other == entering || history.trace(x, y, timeUs, polarity, other.motion()) >= SURE_TRACE ? null
                : entering;
        }
        return ground.has(other, history, x, y, timeUs, polarity) ? ground.plane() : null;
    }

    /** The widest of the textures that enter the picture at a place and go on from there; null for none. */
    private TrackPlane entering(PixelHistory history, int x, int y, long timeUs) {
        TrackPlane widest = null;
        for (int i = 0; i < size; i++) {
            Contour its = planes[i].contour();
            if (planes[i].liveEvents() >= LEAST_OF_TEXTURE && history.cameIn(x, y, timeUs, planes[i].motion())
                    && its.goesOnFrom(x, y, timeUs) && (widest == null || its.extent() > widest.contour().extent())) {
                widest = planes[i];
            }
        }
        return widest;
    }

    /** The plane along whose motion the edge came, or that remembers its place. */
    private TrackPlane byTrace(TrackPlane remembering, PixelHistory history, double noise, int x, int y, long timeUs,
                               int polarity) {
        int least = remembering == null ? 0 : noiseTrace(remembering, noise, REMEMBERED_SIGMAS, x, y, timeUs);
        if (!isOfferedBeside(remembering) && (least < DARK_TRACE || remembering.isBent(x, y, timeUs))) {
            return remembering;
        }
        int trace = remembering == null ? 0 : history.trace(x, y, timeUs, polarity, remembering.motion());
        TrackPlane its = farther(trace + CLEAR_TRACE, remembering, history, x, y, timeUs, polarity);
        if (its == remembering) {
            return trace < Math.max(LEAST_TRACE, least) ? null : its;
        }
        int leastOfOther = noiseTrace(its, noise, OTHER_SIGMAS, x, y, timeUs);
        return trace + CLEAR_TRACE >= leastOfOther
            || history.trace(x, y, timeUs, polarity, its.motion()) >= leastOfOther ? its : null;
    }

    private static int noiseTrace(TrackPlane plane, double noise, double sigmas, int x, int y, long timeUs) {
        double vx = plane.motion().vxAt(x, y, timeUs);
        double vy = plane.motion().vyAt(x, y, timeUs);
        return Noise.trace(noise, Math.sqrt(vx * vx + vy * vy), sigmas);
    }

    private boolean isOfferedBeside(TrackPlane plane) {
        return size > 1 || size == 1 && planes[0] != plane;
    }

    /** The plane along whose motion the edge came farthest, if by more than a trace; else the one that is known. */
    private TrackPlane farther(int trace, TrackPlane known, PixelHistory history, int x, int y, long timeUs,
                               int polarity) {
        int farthest = trace;
        TrackPlane its = known;
        for (int i = 0; i < size; i++) {
            if (planes[i] != known) {
                int other = history.traceBeyond(farthest, x, y, timeUs, polarity, planes[i].motion());
                if (other > farthest) {
                    farthest = other;
                    its = planes[i];
                }
            }
        }
        return its;
    }

    /** Whether the plane that has the event has it because both come into sight there. */
    boolean isAppearing() {
        return isAppearing;
    }

    /** Whether it is doubtful that the event is of the plane that has it. */
    boolean isDoubtful() {
        return closeSupport < best.sureSupport();
    }

    /** Whether two contours are about as near, so that the event should measure neither motion. */
    boolean areClose() {
        return second > SHARED_SCORE * most;
    }

    /** Whether the support by the contour of the plane that has the event is weak. */
    boolean isWeak() {
        return support < WEAK * best.threshold();
    }
}
