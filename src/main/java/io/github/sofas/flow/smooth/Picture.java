package io.github.sofas.flow.smooth;

import io.github.sofas.event.SensorSize;

/**
 * Picture of a contour: the places of its events when moved to one time. It is laid on the picture of another contour
 * to see whether both show the same structure.
 */
final class Picture {
    /** Greatest shift of another picture, along each axis, from where the middles of both coincide, in px. */
    static final int SEARCHED_PX = 6;
    private static final int BORDER = SEARCHED_PX + 2;
    /** Most events; more of them show nothing new. */
    private static final int MOST_EVENTS = 1 << 15;

    private final int width;
    private final int height;
    /** Whether an event lies on a pixel or next to it. */
    private final boolean[] near;
    private final short[] columns = new short[MOST_EVENTS];
    private final short[] rows = new short[MOST_EVENTS];
    private int events;
    private double sumX;
    private double sumY;
    private double sumXx;
    private double sumXy;
    private double sumYy;

    Picture(SensorSize sensor) {
        width = sensor.width() + 2 * BORDER;
        height = sensor.height() + 2 * BORDER;
        near = new boolean[width * height];
    }

    /** Bytes of its arrays. */
    static long bytes(SensorSize sensor) {
        return (long) (sensor.width() + 2 * BORDER) * (sensor.height() + 2 * BORDER)
            + 2L * Short.BYTES * MOST_EVENTS;
    }

    /** Forgets all events. */
    void clear() {
        for (int i = 0; i < events; i++) {
            mark(columns[i], rows[i], false);
        }
        events = 0;
        sumX = 0;
        sumY = 0;
        sumXx = 0;
        sumXy = 0;
        sumYy = 0;
    }

    private void mark(int column, int row, boolean is) {
        for (int k = (row - 1) * width + column; k <= (row + 1) * width + column; k += width) {
            near[k - 1] = is;
            near[k] = is;
            near[k + 1] = is;
        }
    }

    /**
     * Adds an event that was moved to a place. An event that left the sensor by more than a few px is left out, and so
     * is one beyond the first {@value #MOST_EVENTS}.
     */
    void add(double x, double y) {
        int column = (int) Math.floor(x) + BORDER;
        int row = (int) Math.floor(y) + BORDER;
        if (column < 1 || column >= width - 1 || row < 1 || row >= height - 1 || events == MOST_EVENTS) {
            return;
        }
        columns[events] = (short) column;
        rows[events++] = (short) row;
        mark(column, row, true);
        sumX += x;
        sumY += y;
        sumXx += x * x;
        sumXy += x * y;
        sumYy += y * y;
    }

    /** Number of events. */
    int events() {
        return events;
    }

    /** Mean column of the events in px. */
    double middleX() {
        return sumX / events;
    }

    /** Mean row. */
    double middleY() {
        return sumY / events;
    }

    /** Standard deviation of the events' places in the direction in which it is smallest, in px. */
    double thickness() {
        double xx = sumXx / events - middleX() * middleX();
        double xy = sumXy / events - middleX() * middleY();
        double yy = sumYy / events - middleY() * middleY();
        double smaller = (xx + yy) / 2 - Math.sqrt((xx - yy) * (xx - yy) / 4 + xy * xy);
        return Math.sqrt(Math.max(0, smaller));
    }

    /**
     * How well two pictures agree: the share of the events of one that lie within a px of events of the other, the
     * smaller of the two shares, where the other lies best. Both must have events.
     */
    double agreement(Picture other) {
        int dx = (int) Math.rint(other.middleX() - middleX());
        int dy = (int) Math.rint(other.middleY() - middleY());
        double greatest = 0;
        for (int y = dy - SEARCHED_PX; y <= dy + SEARCHED_PX; y++) {
            for (int x = dx - SEARCHED_PX; x <= dx + SEARCHED_PX; x++) {
                double share = shareOn(other, x, y);
                if (share > greatest) {
                    greatest = Math.max(greatest, Math.min(share, other.shareOn(this, -x, -y)));
                }
            }
        }
        return greatest;
    }

    private double shareOn(Picture other, int dx, int dy) {
        int count = 0;
        for (int i = 0; i < events; i++) {
            int column = columns[i] + dx;
            int row = rows[i] + dy;
            boolean isInside = column >= 0 && column < width && row >= 0 && row < height;
            count += isInside && other.near[row * width + column] ? 1 : 0;
        }
        return (double) count / events;
    }
}
