package io.github.sofas.flow.track;

import java.util.Arrays;

/**
 * Lays a contour on events: finds the shift and the turn by which most of them come to lie near it. Ours, because a
 * velocity needs some pixels of travel to be seen, while a place needs a dozen events.
 *
 * <p>An event counts by how much nearer to the contour it lies than {@value #REACH_PX} px; from that, a shift or turn
 * takes the square of the px that it moves the contour by, so that few events move it little.
 */
final class Registration {
    /** Events farther from the contour than this count nothing. */
    static final int REACH_PX = 4;
    /** Cells around the sensor, for contours that leave it. */
    private static final int MARGIN = Contour.MARGIN;
    private static final int MOST_EVENTS = 128;
    private static final int FEWEST_EVENTS = 4;
    /** Nearness is kept in eighths of a px. */
    private static final int PART = 8;
    /** Standard deviations by which an agreement must pass that of events at random places. */
    private static final double CHANCE_SIGMAS = 2;
    private static final double FIRST_STEP_PX = 2;
    private static final double LAST_STEP_PX = 0.25;
    /** Nearness around a point of the contour. */
    private static final byte[] CONE = new byte[(2 * REACH_PX - 1) * (2 * REACH_PX - 1)];

    static {
        int i = 0;
        for (int dy = 1 - REACH_PX; dy < REACH_PX; dy++) {
            for (int dx = 1 - REACH_PX; dx < REACH_PX; dx++) {
                CONE[i++] = (byte) Math.max(0, Math.rint(PART * (REACH_PX - Math.sqrt(dx * dx + dy * dy))));
            }
        }
    }

    private final int width;
    private final int height;
    private final byte[] near;
    // box of the cells that are near
    private int minX;
    private int minY;
    private int maxX;
    private int maxY;

    private double centreX;
    private double centreY;
    private final float[] eventX = new float[MOST_EVENTS];
    private final float[] eventY = new float[MOST_EVENTS];
    private int size;

    private double shiftX;
    private double shiftY;
    private double turn;
    private double agreement;

    Registration(int sensorWidth, int sensorHeight) {
        width = sensorWidth + 2 * MARGIN;
        height = sensorHeight + 2 * MARGIN;
        near = new byte[width * height];
        forgetBox();
    }

    /** Bytes that its arrays take. */
    static long bytes(int sensorWidth, int sensorHeight) {
        return (sensorWidth + 2L * MARGIN) * (sensorHeight + 2L * MARGIN) + 2L * MOST_EVENTS * Float.BYTES;
    }

    private void forgetBox() {
        minX = width;
        minY = height;
        maxX = -1;
        maxY = -1;
    }

    /** Begins with no contour and no events; the contour may turn about a centre. */
    void start(double newCentreX, double newCentreY) {
        for (int row = minY; row <= maxY; row++) {
            Arrays.fill(near, row * width + minX, row * width + maxX + 1, (byte) 0);
        }
        forgetBox();
        centreX = newCentreX;
        centreY = newCentreY;
        size = 0;
    }

    /** Adds a point of the contour, in px. */
    void addContour(double x, double y) {
        int column = (int) Math.rint(x) + MARGIN;
        int row = (int) Math.rint(y) + MARGIN;
        if (column < REACH_PX || row < REACH_PX || column >= width - REACH_PX || row >= height - REACH_PX) {
            return;
        }
        int i = 0;
        for (int dy = 1 - REACH_PX; dy < REACH_PX; dy++) {
            int c = (row + dy) * width + column + 1 - REACH_PX;
            for (int dx = 1 - REACH_PX; dx < REACH_PX; dx++) {
                near[c] = (byte) Math.max(near[c], CONE[i++]);
                c++;
            }
        }
        minX = Math.min(minX, column - REACH_PX);
        maxX = Math.max(maxX, column + REACH_PX);
        minY = Math.min(minY, row - REACH_PX);
        maxY = Math.max(maxY, row + REACH_PX);
    }

    /** Adds an event, carried on to the time of the contour, after all of that; not one that is far from it. */
    void addEvent(double x, double y) {
        double column = x + MARGIN;
        double row = y + MARGIN;
        if (size < MOST_EVENTS && column >= minX - REACH_PX && column <= maxX + REACH_PX && row >= minY - REACH_PX
                && row <= maxY + REACH_PX) {
            eventX[size] = (float) x;
            eventY[size] = (float) y;
            size++;
        }
    }

    /** How many events are near, or may be. */
    int size() {
        return size;
    }

    /** Nearness of all events to the contour shifted and turned, in px. */
    private double nearness(double dx, double dy, double angle) {
        int sum = 0;
        for (int i = 0; i < size; i++) {
            double rx = eventX[i] - dx - centreX;
            double ry = eventY[i] - dy - centreY;
            int column = (int) (rx + angle * ry + centreX + (MARGIN + 0.5));
            int row = (int) (ry - angle * rx + centreY + (MARGIN + 0.5));
            if (column >= minX && column <= maxX && row >= minY && row <= maxY) {
                sum += near[row * width + column];
            }
        }
        return (double) sum / PART;
    }

    /** Nearness of an event at a random place of the box, in px. */
    private double chance() {
        long sum = 0;
        for (int row = minY; row <= maxY; row++) {
            for (int c = row * width + minX; c <= row * width + maxX; c++) {
                sum += near[c];
            }
        }
        return (double) sum / PART / ((maxX - minX + 1) * (maxY - minY + 1));
    }

    /**
     * Finds the best place, from where the contour is.
     *
     * @param radius distance of the contour from its centre in px
     * @return whether the events agree with it better than by chance
     */
    boolean fit(double radius) {
        shiftX = 0;
        shiftY = 0;
        turn = 0;
        agreement = 0;
        if (size < FEWEST_EVENTS || maxX < minX) {
            return false;
        }
        double best = nearness(0, 0, 0);
        double step = FIRST_STEP_PX;
        while (step >= LAST_STEP_PX) {
            double better = climb(best, step, radius);
            if (better > best) {
                best = better;
            } else {
                step /= 2;
            }
        }
        double excess = nearness(shiftX, shiftY, turn) - chance() * size;
        agreement = Math.max(0, excess) / REACH_PX;
        return excess > CHANCE_SIGMAS * Math.sqrt(size);
    }

    /** Takes the best of the six single steps, if it is better than a value; returns the value there. */
    private double climb(double value, double step, double radius) {
        double best = value;
        double fromX = shiftX;
        double fromY = shiftY;
        double from = turn;
        for (int k = 0; k < 6; k++) {
            double way = (k & 1) == 0 ? step : -step;
            double dx = k >> 1 == 0 ? fromX + way : fromX;
            double dy = k >> 1 == 1 ? fromY + way : fromY;
            double angle = k >> 1 == 2 ? from + way / radius : from;
            double turned = angle * radius;
            double found = nearness(dx, dy, angle) - dx * dx - dy * dy - turned * turned;
            if (found > best) {
                best = found;
                shiftX = dx;
                shiftY = dy;
                turn = angle;
            }
        }
        return best;
    }

    /** From where the contour was to where it is, x in px. */
    double shiftX() {
        return shiftX;
    }

    double shiftY() {
        return shiftY;
    }

    /** The same, the turn about the centre in rad, positive from x towards y. */
    double turn() {
        return turn;
    }

    /** How many events lie on the contour, less those that would by chance. */
    double agreement() {
        return agreement;
    }
}
