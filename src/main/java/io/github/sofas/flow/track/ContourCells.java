package io.github.sofas.flow.track;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.motion.Bounds;
import java.util.Arrays;

/**
 * Records when events fell on each cell of a track plane's frame, separately for ON and OFF: one bit per sixteenth of
 * the lifetime, the newest in the highest bit. Also keeps the box of the occupied cells. A cell is as large as a pixel.
 * ON has the low half of an int and OFF the high half, so that the surroundings of an event are nine numbers on three
 * cache lines.
 *
 * <p>Ours: support counts sixteenths, not events. A structure that moves differently crosses a cell in a part of the
 * lifetime, with as many events as the structure of the cell gives in all of it. The 3 x 3 cells around an event
 * support it, and events of the other polarity count against it by half: a contour one cell wide would lose events to
 * jitter, and an edge seldom fires both polarities, while mere flicker does.
 *
 * <p>The four nearest cells decide whose an event is, and whether it is doubtful. In a texture, nine cells hold
 * edges of either polarity wherever an event lies.
 */
final class ContourCells {
    /** Cells on each side of the sensor, for the part of a contour that leaves it until the frame is anchored anew. */
    static final int MARGIN = 24;
    /** Number of parts of the lifetime that are distinguished. */
    static final int SIXTEENTHS = Short.SIZE;
    /** In place of a polarity: the polarity that was seen in more sixteenths. */
    static final int EITHER = 0;
    private static final int NEWEST = 1 << SIXTEENTHS - 1;
    private static final int ALL = (1 << SIXTEENTHS) - 1;

    private final int width;
    private final int height;
    /** Sixteenths in which ON and OFF events fell on each cell, OFF in the high half. */
    private final int[] seen;

    /** Box of the cells that {@link #takeTurned} takes over. */
    private final Bounds turned = new Bounds();

    // box of the occupied cells, one cell wider on all sides; beyond it there is no support
    private int minX;
    private int minY;
    private int maxX;
    private int maxY;

    ContourCells(SensorSize sensor) {
        width = sensor.width() + 2 * MARGIN;
        height = sensor.height() + 2 * MARGIN;
        seen = new int[width * height];
        forgetBox();
    }

    /** Bytes that the arrays take. */
    static long bytes(SensorSize sensor) {
        return (long) Integer.BYTES * (sensor.width() + 2 * MARGIN) * (sensor.height() + 2 * MARGIN);
    }

    /** Returns the column or row of the cell at a place in the frame, in px; negative far before the first cell. */
    static int cell(double place) {
        // the cast rounds towards zero, so that the first cell is twice as wide; it never holds an event
        return (int) (place + (MARGIN + 0.5));
    }

    /** Returns the column or row of the first of the two cells nearest to a place, one of which contains the place. */
    static int firstOfTwo(double place) {
        return (int) (place + MARGIN);
    }

    private void forgetBox() {
        minX = width;
        minY = height;
        maxX = 0;
        maxY = 0;
    }

    /** First column of the box. All four sides are inclusive, and never lie on the border of the grid. */
    int minX() {
        return minX;
    }

    int minY() {
        return minY;
    }

    int maxX() {
        return maxX;
    }

    int maxY() {
        return maxY;
    }

    /** Whether no cell is occupied. */
    boolean isEmpty() {
        return minX > maxX;
    }

    /** Whether a cell lies in the box. */
    boolean isInBox(int cx, int cy) {
        return cx >= minX && cx <= maxX && cy >= minY && cy <= maxY;
    }

    boolean isOccupied(int cx, int cy) {
        return seen[cy * width + cx] != 0;
    }

    /**
     * Returns twice the sixteenths in which events of the given polarity fell on the 3 x 3 cells around a cell, less
     * the sixteenths of the other polarity: -16 to 32; 0 beyond the box.
     *
     * @param polarity 1 or -1; {@link #EITHER} for the one that has more
     */
    int support(int cx, int cy, int polarity) {
        if (!isInBox(cx, cy)) {
            return 0;
        }
        return support(around(cy * width + cx), polarity);
    }

    private static int support(int sixteenths, int polarity) {
        int on = Integer.bitCount(sixteenths & ALL);
        int off = Integer.bitCount(sixteenths >>> SIXTEENTHS);
        return polarity == EITHER ? 2 * Math.max(on, off) - Math.min(on, off)
            : polarity > 0 ? 2 * on - off : 2 * off - on;
    }

    /**
     * Returns the support by the four cells nearest to an event. The event's own cell must lie in the box, so that all
     * four cells exist.
     *
     * @param firstX the {@link #firstOfTwo} of the event's column, as firstY is of its row
     */
    int closeSupport(int firstX, int firstY, int polarity) {
        int c = firstY * width + firstX;
        int down = c + width;
        return support(seen[c] | seen[c + 1] | seen[down] | seen[down + 1], polarity);
    }

    /** Unites the sixteenths of 3 x 3 cells. The box keeps one cell from the grid's border, so that all nine exist. */
    private int around(int c) {
        int[] cells = seen;
        int up = c - width;
        int down = c + width;
        return cells[up - 1] | cells[up] | cells[up + 1] | cells[c - 1] | cells[c] | cells[c + 1]
            | cells[down - 1] | cells[down] | cells[down + 1];
    }

    /**
     * Notes an event on the cell at a place in the frame, unless that cell lies on the border of the grid or beyond.
     *
     * @param age in sixteenths, 0 for a current event; from 16 on the event is not noted
     * @return whether the box may have grown
     */
    boolean see(double x, double y, int polarity, int age) {
        int cx = cell(x);
        int cy = cell(y);
        boolean inside = cx > minX && cx < maxX && cy > minY && cy < maxY;
        if (age < SIXTEENTHS) {
            add(cx, cy, NEWEST >> age << (polarity > 0 ? 0 : SIXTEENTHS));
        }
        return !inside;
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

    /** Advances time by some sixteenths: drops older events, and shrinks the box to the cells still occupied. */
    void pass(int sixteenths) {
        int shift = Math.min(sixteenths, SIXTEENTHS);
        int fromX = minX;
        int toX = maxX;
        int fromY = minY;
        int toY = maxY;
        forgetBox();
        for (int cy = fromY; cy <= toY; cy++) {
            pass(cy * width + fromX, cy * width + toX, shift);
            includeRow(cy, fromX, toX);
        }
    }

    private void pass(int from, int to, int shift) {
        int[] cells = seen;
        // ON bits that pass the end of their half fall out, and OFF bits that pass into the half of ON are masked
        int left = ALL >> shift;
        int both = left << SIXTEENTHS | left;
        for (int c = from; c <= to; c++) {
            cells[c] = cells[c] >>> shift & both;
        }
    }

    private void includeRow(int cy, int fromX, int toX) {
        int first = fromX;
        while (first <= toX && !isOccupied(first, cy)) {
            first++;
        }
        if (first > toX) {
            return;
        }
        int last = toX;
        while (!isOccupied(last, cy)) {
            last--;
        }
        include(first, cy);
        include(last, cy);
    }

    /** Takes over, into empty cells, the events of other cells that lie dx cells farther right and dy farther down. */
    void takeShifted(ContourCells from, int dx, int dy) {
        for (int cy = Math.max(1, from.minY - dy); cy <= Math.min(height - 2, from.maxY - dy); cy++) {
            for (int cx = Math.max(1, from.minX - dx); cx <= Math.min(width - 2, from.maxX - dx); cx++) {
                take(cx, cy, from, cx + dx, cy + dy);
            }
        }
    }

    /** Takes over, into empty cells, the events of other cells that a frame has turned, scaled and shifted. */
    void takeTurned(ContourCells from, Frame frame) {
        turned.clear();
        for (int corner = 0; corner < 4; corner++) {
            double x = ((corner & 1) == 0 ? from.minX : from.maxX) - MARGIN;
            double y = ((corner & 2) == 0 ? from.minY : from.maxY) - MARGIN;
            turned.include(frame.toReferenceX(x, y), frame.toReferenceY(x, y));
        }
        int toX = Math.min(width - 2, (int) Math.ceil(turned.right()) + MARGIN);
        int toY = Math.min(height - 2, (int) Math.ceil(turned.bottom()) + MARGIN);
        for (int cy = Math.max(1, (int) Math.floor(turned.top()) + MARGIN); cy <= toY; cy++) {
            for (int cx = Math.max(1, (int) Math.floor(turned.left()) + MARGIN); cx <= toX; cx++) {
                int fromX = (int) Math.rint(frame.fromReferenceX(cx - MARGIN, cy - MARGIN)) + MARGIN;
                int fromY = (int) Math.rint(frame.fromReferenceY(cx - MARGIN, cy - MARGIN)) + MARGIN;
                if (from.isInBox(fromX, fromY)) {
                    take(cx, cy, from, fromX, fromY);
                }
            }
        }
    }

    private void take(int cx, int cy, ContourCells from, int fromX, int fromY) {
        int of = from.seen[fromY * width + fromX];
        seen[cy * width + cx] = of;
        if (of != 0) {
            include(cx, cy);
        }
    }

    /** Adds the events of other cells, whose frame follows the same motion. */
    void absorb(ContourCells other, Frame its, Frame own) {
        for (int cy = other.minY; cy <= other.maxY; cy++) {
            for (int cx = other.minX; cx <= other.maxX; cx++) {
                int of = other.seen[cy * width + cx];
                if (of != 0) {
                    double x = its.toReferenceX(cx - MARGIN, cy - MARGIN);
                    double y = its.toReferenceY(cx - MARGIN, cy - MARGIN);
                    add(cell(own.fromReferenceX(x, y)), cell(own.fromReferenceY(x, y)), of);
                }
            }
        }
    }

    /** Adds sixteenths to a cell, unless the cell lies on the border of the grid or beyond. */
    private void add(int cx, int cy, int of) {
        if (cx >= 1 && cy >= 1 && cx < width - 1 && cy < height - 1) {
            seen[cy * width + cx] |= of;
            include(cx, cy);
        }
    }

    /** Empties all cells. */
    void wipe() {
        for (int cy = minY; cy <= maxY; cy++) {
            Arrays.fill(seen, cy * width + minX, cy * width + maxX + 1, 0);
        }
        forgetBox();
    }
}
