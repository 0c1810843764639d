package io.github.sofas.flow.smooth;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.motion.PixelBox;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;

/**
 * The events of a short time, sorted by tiles of the sensor, so that the events around a place are found without a
 * search through all. Within a tile they are in order of time. A tile is open if its events are to be decided anew.
 */
final class Slice {
    /** Side of a tile in px, as a power of two: 32 px. */
    static final int TILE_BITS = 5;
    /** Bits of a row; a column takes as many. */
    private static final int Y_BITS = 15;
    /**
     * Unlabelled events of a tile, as a share of these and the labelled events around, above which they are more than
     * noise.
     */
    private static final double UNEXPLAINED = 0.2;
    /** Events of a tile that a second segment must have for the tile to be shared, as a share of the labelled ones. */
    private static final double SHARED = 0.02;

    final long fromUs;
    final long untilUs;
    final long from;
    final long until;
    /** Noise events per µs that a pixel gave, of each polarity. */
    final double noisePerUs;
    private final int columns;
    private final int rows;
    /**
     * Events by tile, counted from the slice's first one; the time of each, in µs since the slice began, and its place.
     */
    private final int[] order;
    private final int[] afterUs;
    private final int[] places;
    private final int[] start;
    private final boolean[] open;
    private final boolean[] nearOpen;
    private final Map<Integer, PixelBox> boxes = new HashMap<>();
    private boolean isStale;
    private SegmentEvents bySegment;

    Slice(EventWindow window, SensorSize sensor, long from, long fromUs, long untilUs, double noisePerUs) {
        this.noisePerUs = noisePerUs;
        this.fromUs = fromUs;
        this.untilUs = untilUs;
        this.from = from;
        until = window.end();
        columns = (sensor.width() - 1 >> TILE_BITS) + 1;
        rows = (sensor.height() - 1 >> TILE_BITS) + 1;
        start = new int[columns * rows + 1];
        open = new boolean[columns * rows];
        nearOpen = new boolean[columns * rows];
        order = sort(window, sensor);
        afterUs = new int[order.length];
        places = new int[order.length];
        for (int k = 0; k < order.length; k++) {
            int at = window.at(from + order[k]);
            afterUs[k] = (int) (window.timeUs[at] - fromUs);
            places[k] = window.x[at] << Y_BITS + 1 | window.y[at] << 1 | (window.polarity[at] > 0 ? 1 : 0);
        }
        findOpen(window);
    }

    /** Most bytes that its arrays take if it holds at most so many events. */
    static long mostBytes(SensorSize sensor, int mostEvents) {
        long tiles = (sensor.width() - 1L >> TILE_BITS) + 1;
        tiles *= (sensor.height() - 1L >> TILE_BITS) + 1;
        return Integer.BYTES * (4L * mostEvents + tiles) + 2 * tiles;
    }

    private int[] sort(EventWindow window, SensorSize sensor) {
        for (long i = from; i < until; i++) {
            int k = window.at(i);
            if (sensor.contains(window.x[k], window.y[k])) {
                start[tile(window.x[k], window.y[k]) + 1]++;
                if (window.segment[k] != 0) {
                    boxes.computeIfAbsent(window.segment[k], id -> new PixelBox()).add(window.x[k], window.y[k]);
                }
            }
        }
        for (int t = 0; t < columns * rows; t++) {
            start[t + 1] += start[t];
        }
        int[] next = Arrays.copyOf(start, columns * rows);
        int[] sorted = new int[start[columns * rows]];
        for (long i = from; i < until; i++) {
            int k = window.at(i);
            if (sensor.contains(window.x[k], window.y[k])) {
                sorted[next[tile(window.x[k], window.y[k])]++] = (int) (i - from);
            }
        }
        return sorted;
    }

    /** Gives the events of a segment to another that proved to be the same. */
    void join(int segment, int to) {
        relabel();
        PixelBox joined = boxes.remove(segment);
        if (joined != null) {
            boxes.computeIfAbsent(to, id -> new PixelBox()).add(joined);
        }
    }

    /** Notes that events of the slice were given to other segments. */
    void relabel() {
        bySegment = null;
    }

    /** The events of the slice by the segments that they have now. */
    SegmentEvents bySegment(EventWindow window) {
        if (bySegment == null) {
            bySegment = new SegmentEvents(window, from, until);
        }
        return bySegment;
    }

    /** Notes that segments got one label, which may close tiles. */
    void outdate() {
        isStale = true;
    }

    /** Finds the open tiles anew if segments were joined. */
    void refresh(EventWindow window) {
        if (isStale) {
            isStale = false;
            Arrays.fill(open, false);
            Arrays.fill(nearOpen, false);
            findOpen(window);
        }
    }

    private void findOpen(EventWindow window) {
        int[] labelled = new int[columns * rows];
        boolean[] shared = new boolean[columns * rows];
        for (int t = 0; t < labelled.length; t++) {
            int first = 0;
            int others = 0;
            for (int k = start[t]; k < start[t + 1]; k++) {
                int label = window.label[window.at(from + order[k])];
                if (label != 0) {
                    labelled[t]++;
                    first = first == 0 ? label : first;
                    others += label == first ? 0 : 1;
                }
            }
            shared[t] = Math.min(others, labelled[t] - others) > SHARED * labelled[t];
        }
        for (int t = 0; t < labelled.length; t++) {
            int about = 0;
            for (int r = firstRow(t); r <= lastRow(t); r++) {
                for (int c = firstColumn(t); c <= lastColumn(t); c++) {
                    about += labelled[r * columns + c];
                    open[t] |= shared[r * columns + c];
                }
            }
            int unlabelled = start[t + 1] - start[t] - labelled[t];
            open[t] |= unlabelled > UNEXPLAINED * (unlabelled + about / 3.0);
        }
        for (int t = 0; t < labelled.length; t++) {
            if (open[t]) {
                openAround(t);
            }
        }
    }

    /**
     * Opens the tiles of a box: a segment that was found later, or was lost, may have events there.
     *
     * @param left column of its first tiles; right is that of its last ones, and so on
     */
    void open(int left, int top, int right, int bottom) {
        for (int row = top; row <= bottom; row++) {
            for (int column = left; column <= right; column++) {
                open[row * columns + column] = true;
                openAround(row * columns + column);
            }
        }
    }

    private void openAround(int tile) {
        for (int r = firstRow(tile); r <= lastRow(tile); r++) {
            for (int c = firstColumn(tile); c <= lastColumn(tile); c++) {
                nearOpen[r * columns + c] = true;
            }
        }
    }

    private int firstRow(int tile) {
        return Math.max(0, tile / columns - 1);
    }

    private int lastRow(int tile) {
        return Math.min(rows - 1, tile / columns + 1);
    }

    private int firstColumn(int tile) {
        return Math.max(0, tile % columns - 1);
    }

    private int lastColumn(int tile) {
        return Math.min(columns - 1, tile % columns + 1);
    }

    private int tile(int x, int y) {
        return (y >> TILE_BITS) * columns + (x >> TILE_BITS);
    }

    /** The middle of its time in µs. */
    long middleUs() {
        return (fromUs + untilUs) / 2;
    }

    /** Number of tiles in a row. */
    int columns() {
        return columns;
    }

    /** Number of rows of tiles. */
    int rows() {
        return rows;
    }

    /** Place in the order where the events of a tile begin. */
    int start(int tile) {
        return start[tile];
    }

    /** Number of the k-th event in the order of tiles. */
    long event(int k) {
        return from + order[k];
    }

    /** Time of the k-th event, in µs since the slice began. */
    int afterUs(int k) {
        return afterUs[k];
    }

    /** Column of the k-th event. */
    int x(int k) {
        return places[k] >> Y_BITS + 1;
    }

    /** Row of the k-th event. */
    int y(int k) {
        return places[k] >> 1 & (1 << Y_BITS) - 1;
    }

    /** Whether the k-th event is an ON event. */
    boolean isOn(int k) {
        return (places[k] & 1) != 0;
    }

    /** Place in the order of the first event of a tile at or after a time. */
    int firstFrom(int tile, long us) {
        int low = start[tile];
        int high = start[tile + 1];
        if (us <= fromUs) {
            return low;
        }
        while (low < high) {
            int middle = low + high >>> 1;
            if (afterUs[middle] < us - fromUs) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low;
    }

    /** Whether the events of a tile are to be decided anew: several segments may have them, or many have none. */
    boolean isOpen(int tile) {
        return open[tile];
    }

    /** Whether a tile or one around it is open: its events may come from there or go there. */
    boolean isNearOpen(int tile) {
        return nearOpen[tile];
    }

    /** Whether any of its events had the label of a segment when the slice was complete. */
    boolean has(int segment) {
        return boxes.containsKey(segment);
    }

    /** The segment that had most events when the slice was complete; 0 if none had any. */
    int largest() {
        int largest = 0;
        int most = 0;
        for (Map.Entry<Integer, PixelBox> box : boxes.entrySet()) {
            int more = box.getValue().events - most;
            if (more > 0 || more == 0 && box.getKey() < largest) {
                largest = box.getKey();
                most += more;
            }
        }
        return largest;
    }

    /** Box of the events of a segment; null if it has none. */
    PixelBox box(int segment) {
        return boxes.get(segment);
    }
}
