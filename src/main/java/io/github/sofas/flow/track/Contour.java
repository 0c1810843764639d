package io.github.sofas.flow.track;

import io.github.sofas.flow.PixelConsumer;
import io.github.sofas.flow.motion.Motion;
import io.github.sofas.flow.motion.Projection;
import io.github.sofas.flow.motion.SteppedProjection;
import java.util.Arrays;

/**
 * The contour of a track plane: the cells that its live events fall on when projected to a reference time (paper,
 * section Track Plane), in pixels of the sensor at that time, ON and OFF counted apart.
 *
 * <p>Ours: an event lies on the contour when the 3 x 3 cells around it hold enough live events of its polarity; those
 * of the other polarity count against it by half. A contour one cell wide would lose events to jitter, and an edge
 * seldom fires both ways, while what merely flickers does.
 */
final class Contour {
    /** Cells around the sensor, for what leaves it between two projections. */
    static final int MARGIN = 24;
    private static final int ONE_ON = 1;
    private static final int ONE_OFF = 1 << 16;
    private static final int LEAST_SUPPORT = 4;
    /** Events are projected anew in steps of this part of a cell: far less than they jitter. */
    private static final double STEP_PX = 1.0 / 16;
    /** Share of the mean support that puts an event on the contour: one cell wide, it would lose events to noise. */
    private static final double SHARE = 0.15;

    private final int width;
    private final int height;
    /** Live events per cell: ON in the low half, OFF in the high half. */
    private final int[] grid;
    private final Motion motion = new Motion();
    private final SteppedProjection stepped = new SteppedProjection();
    private int fixedVx;
    private int fixedVy;
    // box of the occupied cells, a cell wider all round; beyond it there is no support
    private int minX;
    private int minY;
    private int maxX;
    private int maxY;

    private int threshold;
    private double centreX;
    private double centreY;
    private double radius;
    private double polarity;

    Contour(int sensorWidth, int sensorHeight) {
        width = sensorWidth + 2 * MARGIN;
        height = sensorHeight + 2 * MARGIN;
        grid = new int[width * height];
    }

    /** The motion that events are projected along until the next {@link #project}. */
    Motion motion() {
        return motion;
    }

    /** Least support that puts an event on the contour. */
    int threshold() {
        return threshold;
    }

    /** Centre of the contour at its reference time, x in px. */
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

    /** Mean polarity of the live events: 1 or -1 where all are ON or OFF, about 0 for a whole object. */
    double polarity() {
        return polarity;
    }

    /** Support of an event: twice the live events around its cell of its own polarity, less those of the other. */
    int support(int x, int y, long timeUs, int polarity) {
        long dt = timeUs - motion.referenceUs;
        int cx = x + MARGIN - Projection.travelled(fixedVx, dt);
        int cy = y + MARGIN - Projection.travelled(fixedVy, dt);
        if (motion.omega != 0) {
            double turn = motion.omega * dt * 1e-6;
            double rx = cx - MARGIN - motion.centreX;
            double ry = cy - MARGIN - motion.centreY;
            cx += (int) Math.rint(turn * ry);
            cy -= (int) Math.rint(turn * rx);
        }
        if (cx < minX || cx > maxX || cy < minY || cy > maxY) {
            return 0;
        }
        return supportAt(cy * width + cx, polarity);
    }

    /** The box keeps one cell from the grid's border, so that the neighbours exist. */
    private int supportAt(int c, int polarity) {
        int[] g = grid;
        int up = c - width;
        int down = c + width;
        // all live events together are fewer than 65,536, so neither half overflows
        int sum = g[up - 1] + g[up] + g[up + 1] + g[c - 1] + g[c] + g[c + 1] + g[down - 1] + g[down] + g[down + 1];
        int on = sum & ONE_OFF - 1;
        int off = sum >>> 16;
        return polarity > 0 ? 2 * on - off : 2 * off - on;
    }

    /** Counts a live event on its cell. */
    void add(LiveEvents live, int i) {
        motion.project(live.x[i], live.y[i], live.timeUs[i]);
        count(live, i, motion.x, motion.y);
    }

    private void count(LiveEvents live, int i, double x, double y) {
        int cx = (int) (x + (MARGIN + 0.5));
        int cy = (int) (y + (MARGIN + 0.5));
        if (cx < 1 || cy < 1 || cx >= width - 1 || cy >= height - 1) {
            live.cell[i] = -1;
            return;
        }
        int c = cy * width + cx;
        live.cell[i] = c;
        grid[c] += live.sign[i] > 0 ? ONE_ON : ONE_OFF;
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

    /** Takes a live event off its cell. */
    void remove(LiveEvents live, int i) {
        if (live.cell[i] >= 0) {
            grid[live.cell[i]] -= live.sign[i] > 0 ? ONE_ON : ONE_OFF;
        }
    }

    /** Empties the cells of all live events. */
    void clear(LiveEvents live) {
        for (int k = 0; k < live.size(); k++) {
            int c = live.cell[live.index(k)];
            if (c >= 0) {
                grid[c] = 0;
            }
        }
        forgetBox();
        threshold = LEAST_SUPPORT;
    }

    private void forgetBox() {
        minX = width;
        minY = height;
        maxX = 0;
        maxY = 0;
    }

    private void follow(Motion along) {
        motion.copyFrom(along);
        fixedVx = Projection.fixed(motion.vx);
        fixedVy = Projection.fixed(motion.vy);
    }

    /** Projects all live events anew, along another motion. */
    void project(LiveEvents live, Motion along) {
        int lastMinX = minX;
        int lastMinY = minY;
        int lastMaxX = maxX;
        int lastMaxY = maxY;
        clear(live);
        follow(along);
        if (live.size() > 0) {
            stepped.begin(motion, motion.referenceUs - live.oldestUs(), 2 * radius, STEP_PX);
        }
        for (int k = 0; k < live.size(); k++) {
            int i = live.index(k);
            stepped.advance(live.timeUs[i]);
            count(live, i, stepped.x(live.x[i], live.y[i]), stepped.y(live.x[i], live.y[i]));
        }
        if (minX > maxX && live.size() > 0) {
            // all have left the grid: the structure was seen last where it was
            minX = lastMinX;
            minY = lastMinY;
            maxX = lastMaxX;
            maxY = lastMaxY;
        }
        measure(live);
    }

    /**
     * Lists where the contour runs at its reference time, from its centre in px.
     *
     * @return how many points there are, also where there is not room for all
     */
    int list(float[] x, float[] y) {
        int n = 0;
        for (int cy = minY; cy <= maxY; cy++) {
            for (int cx = minX; cx <= maxX; cx++) {
                if (isContour(cy * width + cx)) {
                    if (n < x.length) {
                        x[n] = (float) (cx - MARGIN - centreX);
                        y[n] = (float) (cy - MARGIN - centreY);
                    }
                    n++;
                }
            }
        }
        return n;
    }

    /** Whether an event of either polarity on an occupied cell is on the contour. */
    private boolean isContour(int c) {
        return grid[c] != 0 && Math.max(supportAt(c, 1), supportAt(c, -1)) >= threshold;
    }

    /**
     * Draws a contour that does not depend on live events, and takes events of either polarity.
     *
     * @param x places of its points from the centre of a motion, before they turned by an angle
     * @param knownRadius of the structure
     */
    void draw(float[] x, float[] y, int n, Motion along, double angle, double knownRadius) {
        wipe();
        follow(along);
        double cos = StrictMath.cos(angle);
        double sin = StrictMath.sin(angle);
        for (int i = 0; i < n; i++) {
            int cx = (int) Math.rint(motion.centreX + cos * x[i] - sin * y[i]) + MARGIN;
            int cy = (int) Math.rint(motion.centreY + sin * x[i] + cos * y[i]) + MARGIN;
            if (cx >= 1 && cy >= 1 && cx < width - 1 && cy < height - 1) {
                // as many of both that two cells near are enough: an edge passes through as many
                grid[cy * width + cx] = LEAST_SUPPORT / 2 * (ONE_ON + ONE_OFF);
                include(cx, cy);
            }
        }
        threshold = LEAST_SUPPORT;
        centreX = motion.centreX;
        centreY = motion.centreY;
        radius = knownRadius;
    }

    /** Empties all cells. */
    void wipe() {
        for (int cy = minY; cy <= maxY; cy++) {
            Arrays.fill(grid, cy * width + minX, cy * width + maxX + 1, 0);
        }
        forgetBox();
    }

    /** Measures threshold, centre and radius from some 256 of the live events. */
    private void measure(LiveEvents live) {
        long support = 0;
        int signs = 0;
        double sumX = 0;
        double sumY = 0;
        double squares = 0;
        int n = 0;
        int stride = Math.max(1, live.size() / 256);
        for (int k = 0; k < live.size(); k += stride) {
            int i = live.index(k);
            int c = live.cell[i];
            if (c < 0) {
                continue;
            }
            support += supportAt(c, live.sign[i]);
            signs += live.sign[i];
            int x = column(c);
            int y = row(c);
            sumX += x;
            sumY += y;
            squares += x * x + y * y;
            n++;
        }
        if (n == 0) {
            radius = 0;
            polarity = 0;
            return;
        }
        threshold = Math.max(LEAST_SUPPORT, (int) (SHARE * support / n));
        polarity = (double) signs / n;
        centreX = sumX / n;
        centreY = sumY / n;
        radius = Math.sqrt(Math.max(0, squares / n - centreX * centreX - centreY * centreY));
    }

    /** Shows the occupied cells that would put an event of either polarity on the contour, carried on to a time. */
    void show(long nowUs, PixelConsumer pixels) {
        long dt = nowUs - motion.referenceUs;
        int travelX = Projection.travelled(fixedVx, dt) - MARGIN;
        int travelY = Projection.travelled(fixedVy, dt) - MARGIN;
        double turn = motion.omega * dt * 1e-6;
        for (int cy = minY; cy <= maxY; cy++) {
            for (int cx = minX; cx <= maxX; cx++) {
                int c = cy * width + cx;
                if (isContour(c)) {
                    int x = cx + travelX - (int) Math.rint(turn * (cy - MARGIN - motion.centreY));
                    int y = cy + travelY + (int) Math.rint(turn * (cx - MARGIN - motion.centreX));
                    if (x >= 0 && x < width - 2 * MARGIN && y >= 0 && y < height - 2 * MARGIN) {
                        pixels.accept(x, y);
                    }
                }
            }
        }
    }

    /** Where a cell lies at the reference time: a column of the sensor, which it may leave by the margin. */
    int column(int cell) {
        return cell % width - MARGIN;
    }

    /** The same, a row. */
    int row(int cell) {
        return cell / width - MARGIN;
    }

    /** Side of the box at the reference time, in px; a column of the sensor, which it may leave by the margin. */
    int left() {
        return minX + 1 - MARGIN;
    }

    int top() {
        return minY + 1 - MARGIN;
    }

    int right() {
        return maxX - 1 - MARGIN;
    }

    int bottom() {
        return maxY - 1 - MARGIN;
    }

    /** Way to the right that its centre has gone since its reference time, in px. */
    double travelX(long nowUs) {
        return motion.vx * (nowUs - motion.referenceUs) * 1e-6;
    }

    /** The same, downwards. */
    double travelY(long nowUs) {
        return motion.vy * (nowUs - motion.referenceUs) * 1e-6;
    }

    /** Longer side of the box in px. */
    int extent() {
        return Math.max(maxX - minX, maxY - minY) - 2;
    }
}
