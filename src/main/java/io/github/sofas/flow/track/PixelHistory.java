package io.github.sofas.flow.track;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.motion.Motion;
import java.util.Arrays;

/**
 * When the last events of each pixel were, ON and OFF apart. From them {@link #trace} tells whether an edge came along
 * a motion.
 *
 * <p>Ours, because contours do not tell structures apart that overlap: each has what its plane was given before. Where
 * the events of late were is the same whatever they were taken for.
 */
final class PixelHistory {
    /** Px of travel that a trace goes back. */
    static final int TRACE_PX = 8;
    /** What a px of travel counts for with an event on the very pixel where the edge was; else 1. */
    static final int ON_THE_PIXEL = 3;
    /** Events that are kept of each pixel and polarity: as many as edges a px apart fire during a trace. */
    private static final int KEPT = 8;
    /** Speed that a px of travel takes its time from where an edge moves more slowly: what stands has none. */
    private static final double SLOWEST_PX_PER_S = 1;
    private static final int NEVER = Integer.MIN_VALUE;
    /** Time after which times are counted from a later origin. */
    private static final long SPAN_US = 1 << 30;

    private final int width;
    private final int height;
    /** Times of the events of each pixel, OFF then ON, the newest first, in µs after the origin. */
    private final int[] times;
    private long originUs;

    PixelHistory(SensorSize sensor) {
        width = sensor.width();
        height = sensor.height();
        times = new int[2 * KEPT * width * height];
        clear();
    }

    /** Bytes of its array. */
    static long bytes(SensorSize sensor) {
        return 2L * KEPT * Integer.BYTES * sensor.width() * sensor.height();
    }

    /** Forgets all events. */
    void clear() {
        Arrays.fill(times, NEVER);
        originUs = Long.MIN_VALUE;
    }

    /** Notes an event. */
    void note(int x, int y, long timeUs, int polarity) {
        if (originUs == Long.MIN_VALUE) {
            originUs = timeUs;
        }
        while (timeUs - originUs >= SPAN_US) {
            moveOrigin(timeUs);
        }
        int newest = newest(x, y, polarity);
        System.arraycopy(times, newest, times, newest + 1, KEPT - 1);
        times[newest] = (int) (timeUs - originUs);
    }

    /** Counts times from a later origin; what was before the one of now is long over. */
    private void moveOrigin(long nowUs) {
        if (nowUs - originUs >= 2 * SPAN_US) {
            clear();
            originUs = nowUs;
            return;
        }
        for (int i = 0; i < times.length; i++) {
            times[i] = times[i] < 0 ? NEVER : (int) (times[i] - SPAN_US);
        }
        originUs += SPAN_US;
    }

    private int newest(int x, int y, int polarity) {
        return ((y * width + x) * 2 + (polarity > 0 ? 1 : 0)) * KEPT;
    }

    /**
     * How far an edge that fires now came along a motion: a px of travel counts {@value #ON_THE_PIXEL} where an event
     * of its polarity was on the very pixel when the edge must have been there, and 1 where one was on a pixel beside
     * it; 0 to 24.
     */
    int trace(int x, int y, long timeUs, int polarity, Motion motion) {
        double vx = motion.vxAt(x, y, timeUs);
        double vy = motion.vyAt(x, y, timeUs);
        double pxUs = 1e6 / Math.max(SLOWEST_PX_PER_S, Math.sqrt(vx * vx + vy * vy));
        double stepX = vx * pxUs * 1e-6;
        double stepY = vy * pxUs * 1e-6;
        double nowUs = timeUs - originUs;
        int trace = 0;
        for (int px = 1; px <= TRACE_PX; px++) {
            trace += met(x - px * stepX, y - px * stepY, polarity, (int) (nowUs - (px + 0.5) * pxUs),
                (int) (nowUs - (px - 0.5) * pxUs));
        }
        return trace;
    }

    /** What a px of travel counts for whose events are those at a place within a time. */
    private int met(double atX, double atY, int polarity, int fromUs, int untilUs) {
        int x = (int) Math.rint(atX);
        int y = (int) Math.rint(atY);
        if (fired(x, y, polarity, fromUs, untilUs)) {
            return ON_THE_PIXEL;
        }
        int besideX = atX > x ? x + 1 : x - 1;
        int besideY = atY > y ? y + 1 : y - 1;
        return fired(besideX, y, polarity, fromUs, untilUs) || fired(x, besideY, polarity, fromUs, untilUs)
            || fired(besideX, besideY, polarity, fromUs, untilUs) ? 1 : 0;
    }

    private boolean fired(int x, int y, int polarity, int fromUs, int untilUs) {
        if (x < 0 || y < 0 || x >= width || y >= height) {
            return false;
        }
        int newest = newest(x, y, polarity);
        for (int i = newest; i < newest + KEPT; i++) {
            if (times[i] < untilUs) {
                return times[i] >= fromUs;
            }
        }
        return false;
    }
}
