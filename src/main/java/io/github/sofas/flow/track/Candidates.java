package io.github.sofas.flow.track;

import java.util.Arrays;

/**
 * Collects the track planes that may own an event, and selects one of them. The event goes to the plane with the
 * nearest contour. If it lies on no contour, it goes to the plane that remembers its place. In both cases another plane
 * gets the event if the edge came farther along the motion of that plane.
 *
 * <p>Ours. A contour consists of the events that its plane was given before. Where structures overlap, the one that was
 * given more events would therefore get still more. {@link PixelHistory} knows the recent events, whatever they were
 * taken for. Edges that come equally far along several motions, as those of the pieces that a body is found in, stay
 * with their piece.
 *
 * <p>Two kinds of structure have no contour yet. One comes out from behind a body: the body would remember the place,
 * follow the events, and be carried away. The other enters the picture: the border cuts off its trace, so that any
 * other plane would have a longer one by chance, and would be carried along the border. Between a wall and a structure
 * that moves in front of it, {@link Ground} decides.
 */
final class Candidates {
    /** Weight of close support in a score: it decides which contour is nearest, and the full support breaks ties. */
    private static final int CLOSE_WEIGHT = 4 * ContourCells.SIXTEENTHS;
    /** Share of the nearest contour's score above which a second one hides the velocity: crossing objects pull. */
    private static final double SHARED_SCORE = 0.5;
    /** Support below this multiple of the threshold is weak. */
    private static final int WEAK = 2;
    /** Least trace of a remembered event that another plane may own: noise has no trace. */
    private static final int LEAST_TRACE = 2;
    /**
     * Standard deviations by which the trace along the motion of the remembering plane must exceed that of noise; and
     * the same for a plane that does not remember the event, where many motions are tried.
     */
    private static final double REMEMBERED_SIGMAS = 3;
    private static final double OTHER_SIGMAS = 5;
    /** Trace of noise from which on a remembered event must exceed noise even if no other plane may own the event. */
    private static final int DARK_TRACE = 5;
    /** Margin by which the trace along the motion of a plane that does not remember the event must be longer. */
    private static final int CLEAR_TRACE = 2 * PixelHistory.ON_THE_PIXEL;
    /** Fewest live events of a texture: where a smaller structure enters, most of the events are not its own. */
    private static final int LEAST_OF_TEXTURE = 2000;
    /** Trace that proves that an edge came along a motion, even where a whole wall fires around the edge. */
    private static final int SURE_TRACE = 6 * PixelHistory.ON_THE_PIXEL;

    /** Planes that expect the event; as long as none does, all planes that it was offered to. */
    private TrackPlane[] planes = new TrackPlane[16];
    private int size;
    private TrackPlane nearest;
    /** Scores of the nearest and of the second contour. */
    private int most;
    private int second;
    // of the plane that gets the event
    private TrackPlane best;
    private int support;
    private int closeSupport;
    private boolean isAppearing;
    private final TracedEvent event;
    private final Ground ground = new Ground();

    /** Creates candidates that trace the edges of events by a history. */
    Candidates(PixelHistory history) {
        event = new TracedEvent(history);
    }

    /** Starts with a new event. */
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

    /** Considers a plane whose box holds the event. The plane expects the event if the event lies on its contour. */
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

    /** Returns the plane that the event belongs to; null if no plane expects the event. */
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

    /** Returns the best plane, the ground behind it, or, if the best plane is the ground, a body in front of it. */
    private TrackPlane beforeGround() {
        if (best == ground.plane()) {
            // a single other plane is the body without a trace
            TrackPlane body = size == 2 ? planes[planes[0] == best ? 1 : 0] : farther(-1, best);
            return ground.yields(body, event) ? body : best;
        }
        return ground.has(best, event) ? ground.plane() : best;
    }

    /**
     * Returns the plane that gets the event although no plane expects it. A texture that enters the picture there gets
     * it, unless the edge clearly came along the motion of another plane. The ground gets it where the ground comes out
     * from behind a body.
     *
     * @param remembering the plane that remembers the place of the event; null for none
     * @param noise noise events per pixel and per µs, of each polarity
     * @return null if the edge came along no motion, or no farther than noise would
     */
    TrackPlane unexpected(TrackPlane remembering, double noise) {
        TrackPlane its = byTrace(remembering, noise);
        TrackPlane appearing = appearing(its);
        return appearing == null ? its : appears(appearing);
    }

    /**
     * The same while the stack tracks nothing but one texture, for which no traces are kept. The texture gets the event
     * if it enters the picture there; else the plane that remembers the place does.
     */
    TrackPlane unexpectedAlone(TrackPlane remembering) {
        TrackPlane entering = entering();
        return entering == null || entering == remembering ? remembering : appears(entering);
    }

    private TrackPlane appears(TrackPlane appearing) {
        isAppearing = true;
        // the contour must know this event as the one whose support was asked for last
        event.support(appearing);
        return appearing;
    }

    /** Returns the texture that comes into sight at the event, which another plane may get otherwise; null for none. */
    private TrackPlane appearing(TrackPlane other) {
        TrackPlane entering = entering();
        if (other == null) {
            return entering;
        }
        if (entering != null) {
            return other == entering || event.trace(other) >= SURE_TRACE ? null : entering;
        }
        return ground.has(other, event) ? ground.plane() : null;
    }

    /** Returns the widest texture that enters the picture at the event and continues from there; null for none. */
    private TrackPlane entering() {
        if (!event.isNearBorder()) {
            return null;
        }
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

    /** Returns the plane along whose motion the edge came, or the one that remembers its place; null for neither. */
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

    /** Returns the plane along whose motion the edge came farthest, if farther than a trace; else the known plane. */
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

    /** Whether the plane gets the event because its structure comes into sight there. */
    boolean isAppearing() {
        return isAppearing;
    }

    /** Whether it is doubtful that the event belongs to the plane that gets it. */
    boolean isDoubtful() {
        return closeSupport < best.sureSupport();
    }

    /**
     * The same for a texture that is alone. What has come in over the border lately cannot have all of the support yet,
     * so that less is asked of it. Beside other planes, an object that enters before the texture would be found later.
     */
    boolean isDoubtfulAlone() {
        return isDoubtful()
            && closeSupport < best.sureSupport() * best.shareInSight(event.x, event.y, event.timeUs);
    }

    /** Whether two contours are about equally near, so that the event should measure neither motion. */
    boolean areClose() {
        return second > SHARED_SCORE * most;
    }

    /** Whether the contour of the plane that gets the event supports it only weakly. */
    boolean isWeak() {
        return support < WEAK * best.threshold();
    }
}
