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
    private final TracedEvent event;
    private final Ground ground = new Ground();

    /** Makes one whose events' edges are traced by a history. */
    Candidates(PixelHistory history) {
        event = new TracedEvent(history);
    }

    /** Begins with an event. */
    void begin(int x, int y, long timeUs, int polarity) {
        event.begin(x, y, timeUs, polarity);
        size = 0;
        best = null;
        isAppearing = false;
        ground.clear();
        nearest = null;
        most = Integer.MIN_VALUE;
        second = Integer.MIN_VALUE;
    }

    /** Considers a plane in whose box the event lies; it expects the event if that lies on its contour. */
    void offer(TrackPlane plane) {
        ground.offer(plane);
        int its = event.support(plane);
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
        int close = plane.closeSupport(event.polarity);
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
    TrackPlane best() {
        best = nearest;
        if (nearest != null && size > 1) {
            best = farther(event.trace(nearest) + PixelHistory.ON_THE_PIXEL, nearest);
        }
        if (best != null) {
            best = beforeGround();
        }
        if (best != nearest) {
            support = event.support(best);
            isAppearing = support < best.threshold();
            if (!isAppearing) {
                closeSupport = best.closeSupport(event.polarity);
            }
        }
        return best;
    }

    /** The plane that has the event, or the ground that it moves before, or a body before it if that is the ground. */
    private TrackPlane beforeGround() {
        if (best == ground.plane()) {
            // the only other one needs no trace
            TrackPlane body = size == 2 ? planes[planes[0] == best ? 1 : 0] : farther(-1, best);
            return ground.yields(body, event) ? body : best;
        }
        return ground.has(best, event) ? ground.plane() : best;
    }

    /**
     * The plane that has the event where none expects it: the texture that enters the picture there, unless the edge
     * came along the motion of another beyond doubt; or the ground, where that comes out from behind a body.
     *
     * @param remembering the plane that remembers its place; null for none
     * @param noise how many noise events a pixel gives of either polarity, per µs
     * @return null where its edge came along no motion, or no farther than noise would
     */
    TrackPlane unexpected(TrackPlane remembering, double noise) {
        TrackPlane its = byTrace(remembering, noise);
        TrackPlane appearing = appearing(its);
        if (appearing == null) {
            return its;
        }
        isAppearing = true;
        // it is the event whose support was asked for last
        event.support(appearing);
        return appearing;
    }

    /** The texture that comes into sight where another plane would have the event, or none; null for none. */
    private TrackPlane appearing(TrackPlane other) {
        TrackPlane entering = event.isNearBorder() ? entering() : null;
        if (other == null) {
            return entering;
        }
        if (entering != null) {
            return other == entering || event.trace(other) >= SURE_TRACE ? null : entering;
        }
        return ground.has(other, event) ? ground.plane() : null;
    }

    /** The widest of the textures that enter the picture at a place and go on from there; null for none. */
    private TrackPlane entering() {
        TrackPlane widest = null;
        for (int i = 0; i < size; i++) {
            Contour its = planes[i].contour();
            if (planes[i].liveEvents() >= LEAST_OF_TEXTURE && event.cameIn(planes[i])
                    && its.goesOnFrom(event.x, event.y, event.timeUs)
                    && (widest == null || its.extent() > widest.contour().extent())) {
                widest = planes[i];
            }
        }
        return widest;
    }

    /** The plane along whose motion the edge came, or that remembers its place. */
    private TrackPlane byTrace(TrackPlane remembering, double noise) {
        int least = remembering == null ? 0 : noiseTrace(remembering, noise, REMEMBERED_SIGMAS);
        if (!isOfferedBeside(remembering)
                && (least < DARK_TRACE || remembering.isBent(event.x, event.y, event.timeUs))) {
            return remembering;
        }
        int trace = remembering == null ? 0 : event.trace(remembering);
        TrackPlane its = farther(trace + CLEAR_TRACE, remembering);
        if (its == remembering) {
            return trace < Math.max(LEAST_TRACE, least) ? null : its;
        }
        int leastOfOther = noiseTrace(its, noise, OTHER_SIGMAS);
        return trace + CLEAR_TRACE >= leastOfOther || event.trace(its) >= leastOfOther ? its : null;
    }

    private int noiseTrace(TrackPlane plane, double noise, double sigmas) {
        double vx = plane.motion().vxAt(event.x, event.y, event.timeUs);
        double vy = plane.motion().vyAt(event.x, event.y, event.timeUs);
        return Noise.trace(noise, Math.sqrt(vx * vx + vy * vy), sigmas);
    }

    private boolean isOfferedBeside(TrackPlane plane) {
        return size > 1 || size == 1 && planes[0] != plane;
    }

    /** The plane along whose motion the edge came farthest, if by more than a trace; else the one that is known. */
    private TrackPlane farther(int trace, TrackPlane known) {
        int farthest = trace;
        TrackPlane its = known;
        for (int i = 0; i < size; i++) {
            if (planes[i] != known) {
                int other = event.traceBeyond(farthest, planes[i]);
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
