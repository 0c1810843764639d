package io.github.sofas.flow.track;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.PixelConsumer;
import io.github.sofas.flow.motion.Motion;
import io.github.sofas.flow.motion.SteppedProjection;
import java.util.Arrays;

/**
 * The contour of a track plane: the cells of its frame that its events fell on of late (paper, section Track Plane), ON
 * and OFF counted apart. A count fades by an eighth each sixteenth of the lifetime.
 *
 * <p>Ours: an event lies on the contour when the 3 x 3 cells around it hold enough events of its polarity; those of the
 * other polarity count against it by half. A contour one cell wide would lose events to jitter, and an edge seldom
 * fires both ways, while what merely flickers does. Counts fade instead of being taken back event by event, and stay
 * where they are when the motion is known a little better: so a label costs the same at any density, and all else is
 * paid per travel.
 *
 * <p>Longer than other classes, because the counts, their box and their frame change together: anchoring, drawing and
 * absorbing touch all three.
 */
final class Contour {
    /** Cells around the sensor, for what leaves it between two anchorings. */
    static final int MARGIN = 24;
    /** What an event adds to the count of its cell; greater counts stay at the most. */
    private static final int ONE = 32;
    private static final int MOST = Short.MAX_VALUE;
    /** Fadings during a lifetime, each by an eighth: the mean age of a count is half the lifetime. */
    private static final int FADINGS = 16;
    private static final int FADING_BITS = 3;
    /** Support of two events of half their count: fewer never put an event on the contour. */
    private static final int LEAST_SUPPORT = 2 * ONE;
    /** Departure of the frame from the sensor at which it is anchored anew, in px; less than the margin. */
    private static final double FARTHEST_PX = 12;
    /** Least shift over the lifetime by a correction of the motion for the contour to be drawn anew, in px. */
    static final double REDRAWN_PX = 0.5;
    /** Share of the mean support that puts an event on the contour: one a pixel wide loses events to jitter. */
    private static final double SHARE = 0.15;
    /** Live events that threshold, centre and radius are measured from. */
    private static final int SAMPLE = 256;

    private final int sensorWidth;
    private final int sensorHeight;
    private final int width;
    private final int height;
    /** Counts of ON and OFF events by cell. */
    private short[] on;
    private short[] off;
    /** Cells to anchor anew with, of any contour. */
    private final Spare spare;
    private final Frame frame = new Frame();
    private final SteppedProjection past = new SteppedProjection();
    private long fadedUs;

    // box of the occupied cells, a cell wider all round; beyond it there is no support
    private int minX;
    private int minY;
    private int maxX;
    private int maxY;

    private int threshold;
    private double centreX;
    private double centreY;
    private double radius;

    /** Cells that contours of one sensor use in turn while they are anchored anew. */
    static final class Spare {
        private short[] on;
        private short[] off;

        Spare(SensorSize sensor) {
            on = new short[cells(sensor)];
            off = new short[cells(sensor)];
        }
    }

    Contour(SensorSize sensor, Spare spare) {
        this.spare = spare;
        sensorWidth = sensor.width();
        sensorHeight = sensor.height();
        width = sensorWidth + 2 * MARGIN;
        height = sensorHeight + 2 * MARGIN;
        on = new short[cells(sensor)];
        off = new short[cells(sensor)];
        forgetBox();
    }

    private static int cells(SensorSize sensor) {
        return (sensor.width() + 2 * MARGIN) * (sensor.height() + 2 * MARGIN);
    }

    /** Bytes of its arrays. */
    static long bytes(SensorSize sensor) {
        return 2L * Short.BYTES * cells(sensor);
    }

    /** Begins without events, along a motion. */
    void start(Motion along) {
        wipe();
        frame.anchor(along, 0);
        fadedUs = along.referenceUs;
        threshold = LEAST_SUPPORT;
        centreX = 0;
        centreY = 0;
        radius = 0;
    }

    /** Least support that puts an event on the contour. */
    int threshold() {
        return threshold;
    }

    /** Centre of the contour at the last {@link #measure}, x in px of the sensor. */
    double centreX() {
        return centreX;
    }

    double centreY() {
        return centreY;
    }

    /** Distance of the contour from its centre, root of the mean square, in px. */
    double radius() {
        return radius;
    }

    /** Support of an event: twice the events of late around its cell of its own polarity, less those of the other. */
    int support(int x, int y, long timeUs, int polarity) {
        frame.advance(timeUs);
        int cx = (int) (frame.x(x, y) + (MARGIN + 0.5));
        int cy = (int) (frame.y(x, y) + (MARGIN + 0.5));
        if (cx < minX || cx > maxX || cy < minY || cy > maxY) {
            return 0;
        }
        return supportAt(cy * width + cx, polarity);
    }

    /** The box keeps one cell from the grid's border, so that the neighbours exist. */
    private int supportAt(int c, int polarity) {
        short[] own = polarity > 0 ? on : off;
        short[] other = polarity > 0 ? off : on;
        return 2 * around(own, c) - around(other, c);
    }

    private int around(short[] count, int c) {
        int up = c - width;
        int down = c + width;
        return count[up - 1] + count[up] + count[up + 1] + count[c - 1] + count[c] + count[c + 1]
            + count[down - 1] + count[down] + count[down + 1];
    }

    /** Counts an event on its cell. */
    void add(int x, int y, long timeUs, int polarity) {
        frame.advance(timeUs);
        count(frame.x(x, y), frame.y(x, y), polarity, ONE);
    }

    private void count(double x, double y, int polarity, int weight) {
        int cx = (int) (x + (MARGIN + 0.5));
        int cy = (int) (y + (MARGIN + 0.5));
        if (cx < 1 || cy < 1 || cx >= width - 1 || cy >= height - 1) {
            return;
        }
        int c = cy * width + cx;
        short[] counts = polarity > 0 ? on : off;
        counts[c] = (short) Math.min(MOST, counts[c] + weight);
        include(cx, cy);
    }

    private void include(int cx, int cy) {
        if (cx <= minX) {
            minX = Math.max(1, cx - 1);
        }
        if (cx >= maxX) {
            maxX = Math.min(width - 2, cx + 1);
        }
        if (cy <= minY) {
            minY = Math.max(1, cy - 1);
        }
        if (cy >= maxY) {
            maxY = Math.min(height - 2, cy + 1);
        }
    }

    private void forgetBox() {
        minX = width;
        minY = height;
        maxX = 0;
        maxY = 0;
    }

    /** Lets the counts fade as far as is due. */
    void fade(long nowUs, long lifetimeUs) {
        long dueUs = Math.max(1, lifetimeUs / FADINGS);
        if (isEmpty()) {
            fadedUs = nowUs;
        }
        if (nowUs - fadedUs < dueUs) {
            return;
        }
        int times = (int) Math.min(2 * FADINGS, (nowUs - fadedUs) / dueUs);
        fadedUs = nowUs;
        int fromX = minX;
        int toX = maxX;
        int toY = maxY;
        int fromY = minY;
        int oldLeft = minX;
        forgetBox();
        for (int cy = fromY; cy <= toY; cy++) {
            int from = cy * width + fromX;
            int to = cy * width + toX;
            for (int k = 0; k < times; k++) {
                fade(on, from, to);
                fade(off, from, to);
            }
            includeRow(cy, from, to, oldLeft);
        }
    }

    private static void fade(short[] count, int from, int to) {
        for (int c = from; c <= to; c++) {
            count[c] = (short) (count[c] - (count[c] + (1 << FADING_BITS) - 1 >> FADING_BITS));
        }
    }

    private void includeRow(int cy, int from, int to, int left) {
        int first = from;
        while (first <= to && (on[first] | off[first]) == 0) {
            first++;
        }
        if (first > to) {
            return;
        }
        int last = to;
        while ((on[last] | off[last]) == 0) {
            last--;
        }
        include(left + first - from, cy);
        include(left + last - from, cy);
    }

    /** Follows another motion from its reference on. */
    void follow(Motion along) {
        frame.follow(along, radius);
        double fromX = frame.toReferenceX(minX - MARGIN, minY - MARGIN);
        double fromY = frame.toReferenceY(minX - MARGIN, minY - MARGIN);
        double toX = frame.toReferenceX(maxX - MARGIN, maxY - MARGIN);
        double toY = frame.toReferenceY(maxX - MARGIN, maxY - MARGIN);
        if (minX <= maxX && (frame.departurePx(fromX, fromY) > FARTHEST_PX
                || frame.departurePx(toX, toY) > FARTHEST_PX)) {
            anchor();
        }
    }

    /** Anchors the frame anew: each cell takes over the counts of the cell that was where it is. */
    private void anchor() {
        short[] fromOn = on;
        short[] fromOff = off;
        int oldMinX = minX;
        int oldMinY = minY;
        int oldMaxX = maxX;
        int oldMaxY = maxY;
        on = spare.on;
        off = spare.off;
        spare.on = fromOn;
        spare.off = fromOff;
        int dx = (int) Math.rint(frame.shiftX());
        int dy = (int) Math.rint(frame.shiftY());
        boolean shifted = frame.isOnlyShifted();
        double left = Double.MAX_VALUE;
        double right = -Double.MAX_VALUE;
        double top = Double.MAX_VALUE;
        double bottom = -Double.MAX_VALUE;
        for (int corner = 0; corner < 4; corner++) {
            double x = ((corner & 1) == 0 ? oldMinX : oldMaxX) - MARGIN;
            double y = ((corner & 2) == 0 ? oldMinY : oldMaxY) - MARGIN;
            double nx = shifted ? x - dx : frame.toReferenceX(x, y);
            double ny = shifted ? y - dy : frame.toReferenceY(x, y);
            left = Math.min(left, nx);
            right = Math.max(right, nx);
            top = Math.min(top, ny);
            bottom = Math.max(bottom, ny);
        }
        int fromX = Math.max(1, (int) Math.floor(left) + MARGIN);
        int toX = Math.min(width - 2, (int) Math.ceil(right) + MARGIN);
        int fromY = Math.max(1, (int) Math.floor(top) + MARGIN);
        int toY = Math.min(height - 2, (int) Math.ceil(bottom) + MARGIN);
        forgetBox();
        for (int cy = fromY; cy <= toY; cy++) {
            for (int cx = fromX; cx <= toX; cx++) {
                int ox;
                int oy;
                if (shifted) {
                    ox = cx + dx;
                    oy = cy + dy;
                } else {
                    ox = (int) Math.rint(frame.fromReferenceX(cx - MARGIN, cy - MARGIN)) + MARGIN;
                    oy = (int) Math.rint(frame.fromReferenceY(cx - MARGIN, cy - MARGIN)) + MARGIN;
                }
                if (ox >= oldMinX && ox <= oldMaxX && oy >= oldMinY && oy <= oldMaxY) {
                    int c = cy * width + cx;
                    int o = oy * width + ox;
                    on[c] = fromOn[o];
                    off[c] = fromOff[o];
                    if ((on[c] | off[c]) != 0) {
                        include(cx, cy);
                    }
                }
            }
        }
        wipe(fromOn, fromOff, oldMinX, oldMinY, oldMaxX, oldMaxY);
        if (shifted) {
            frame.shift(-dx, -dy);
        } else {
            frame.anchorAgain();
        }
    }

    /** Takes over the counts of another contour of the sensor, which is left to be wiped. */
    void absorb(Contour other, Motion along) {
        frame.follow(along, radius);
        anchor();
        other.frame.follow(along, other.radius);
        other.anchor();
        for (int cy = other.minY; cy <= other.maxY; cy++) {
            for (int cx = other.minX; cx <= other.maxX; cx++) {
                int c = cy * width + cx;
                on[c] = (short) Math.min(MOST, on[c] + other.on[c]);
                off[c] = (short) Math.min(MOST, off[c] + other.off[c]);
            }
        }
        if (!other.isEmpty()) {
            include(other.minX, other.minY);
            include(other.maxX, other.maxY);
        }
    }

    /** Draws the contour anew from the live events, along a motion. */
    void draw(LiveEvents live, Motion along, long lifetimeUs) {
        wipe();
        frame.anchor(along, radius);
        fadedUs = along.referenceUs;
        if (live.size() == 0) {
            return;
        }
        past.begin(along, along.referenceUs - live.oldestUs(), 2 * radius, 1.0 / 16);
        long halfUs = Math.max(1, lifetimeUs / 2);
        for (int k = 0; k < live.size(); k++) {
            int i = live.index(k);
            past.advance(live.timeUs[i]);
            // as if it had faded since: to half after 0.7 of half the lifetime
            int weight = (int) (ONE * halfUs / (halfUs + (along.referenceUs - live.timeUs[i])));
            count(past.x(live.x[i], live.y[i]), past.y(live.x[i], live.y[i]), live.sign[i], weight);
        }
    }

    /** Empties all cells. */
    void wipe() {
        wipe(on, off, minX, minY, maxX, maxY);
        forgetBox();
    }

    private void wipe(short[] countsOn, short[] countsOff, int fromX, int fromY, int toX, int toY) {
        for (int cy = fromY; cy <= toY; cy++) {
            Arrays.fill(countsOn, cy * width + fromX, cy * width + toX + 1, (short) 0);
            Arrays.fill(countsOff, cy * width + fromX, cy * width + toX + 1, (short) 0);
        }
    }

    /**
     * Measures threshold, centre and radius from some of the live events.
     *
     * @param along the motion that the contour follows, with its reference at now
     */
    void measure(LiveEvents live, Motion along) {
        int n = 0;
        long support = 0;
        double sumX = 0;
        double sumY = 0;
        double squares = 0;
        int stride = Math.max(1, live.size() / SAMPLE);
        if (live.size() > 0) {
            past.begin(along, along.referenceUs - live.oldestUs(), 2 * radius, 1.0 / 16);
        }
        for (int k = 0; k < live.size(); k += stride) {
            int i = live.index(k);
            past.advance(live.timeUs[i]);
            double x = past.x(live.x[i], live.y[i]);
            double y = past.y(live.x[i], live.y[i]);
            int cx = (int) (frame.fromReferenceX(x, y) + (MARGIN + 0.5));
            int cy = (int) (frame.fromReferenceY(x, y) + (MARGIN + 0.5));
            if (cx < minX || cx > maxX || cy < minY || cy > maxY) {
                continue;
            }
            support += supportAt(cy * width + cx, live.sign[i]);
            sumX += x;
            sumY += y;
            squares += x * x + y * y;
            n++;
        }
        if (n == 0) {
            radius = 0;
            return;
        }
        threshold = Math.max(LEAST_SUPPORT, (int) (SHARE * support / n));
        centreX = sumX / n;
        centreY = sumY / n;
        radius = Math.sqrt(Math.max(0, squares / n - centreX * centreX - centreY * centreY));
    }

    /** Whether an event of either polarity on an occupied cell is on the contour. */
    private boolean isContour(int c) {
        return (on[c] | off[c]) != 0 && Math.max(supportAt(c, 1), supportAt(c, -1)) >= threshold;
    }

    /** Shows the occupied cells that would put an event of either polarity on the contour, carried on to a time. */
    void show(long nowUs, PixelConsumer pixels) {
        Motion motion = frame.motion();
        double dt = (nowUs - motion.referenceUs) * 1e-6;
        for (int cy = minY; cy <= maxY; cy++) {
            for (int cx = minX; cx <= maxX; cx++) {
                if (isContour(cy * width + cx)) {
                    double px = frame.toReferenceX(cx - MARGIN, cy - MARGIN);
                    double py = frame.toReferenceY(cx - MARGIN, cy - MARGIN);
                    int x = (int) Math.rint(px + dt * motion.vxAt((int) px, (int) py, motion.referenceUs));
                    int y = (int) Math.rint(py + dt * motion.vyAt((int) px, (int) py, motion.referenceUs));
                    if (x >= 0 && x < sensorWidth && y >= 0 && y < sensorHeight) {
                        pixels.accept(x, y);
                    }
                }
            }
        }
    }

    /** Side of the box at a time, in px; a column of the sensor, which it may leave. */
    double left(long nowUs) {
        return edgeX(minX + 1) + travelX(nowUs);
    }

    double right(long nowUs) {
        return edgeX(maxX - 1) + travelX(nowUs);
    }

    double top(long nowUs) {
        return edgeY(minY + 1) + travelY(nowUs);
    }

    double bottom(long nowUs) {
        return edgeY(maxY - 1) + travelY(nowUs);
    }

    private double edgeX(int cx) {
        return frame.toReferenceX(cx - MARGIN, (minY + maxY) / 2.0 - MARGIN);
    }

    private double edgeY(int cy) {
        return frame.toReferenceY((minX + maxX) / 2.0 - MARGIN, cy - MARGIN);
    }

    private double travelX(long nowUs) {
        return frame.motion().vx * (nowUs - frame.motion().referenceUs) * 1e-6;
    }

    private double travelY(long nowUs) {
        return frame.motion().vy * (nowUs - frame.motion().referenceUs) * 1e-6;
    }

    /** Whether no cell is occupied. */
    boolean isEmpty() {
        return minX > maxX;
    }

    /** Longer side of the box in px. */
    int extent() {
        return Math.max(maxX - minX, maxY - minY) - 2;
    }
}
