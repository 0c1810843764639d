package io.github.sofas.flow.track;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.motion.Motion;
import io.github.sofas.flow.motion.PixelBox;
import io.github.sofas.flow.motion.SteppedProjection;
import java.util.Arrays;

/**
 * Whether a part of a track plane is a body of its own. The live events are laid on each other along the motion of the
 * plane. A part that lies apart from the others is a body of its own if another velocity makes it sharper beyond doubt.
 * Or else the part is one of two bodies that seem to turn or grow together ({@link TwoBodies}).
 *
 * <p>Ours, because two bodies that moved about alike when they were found or merged have one motion from then on. It is
 * right for neither of them, and each measurement finds the best one for both.
 */
final class Parting {
    /** Side of the cells by which parts lie apart, in px, as a power of two. */
    private static final int CELL_BITS = 2;
    /** Cells around the sensor: along the motion, an event may lie outside the sensor. */
    private static final int MARGIN = 8;
    /** Fewest events of a cell that belongs to a body: a lone event is noise. */
    private static final int LEAST_IN_CELL = 2;
    /** Fewest events of a part that is examined. */
    private static final int LEAST_EVENTS = 60;
    /** Standard deviations that the metric of a part must gain by a velocity of its own. */
    private static final double SHOWN_SIGMAS = 7;
    /**
     * Least and greatest shift of the ends of the window by that velocity, in px: farther off are false tops of the
     * metric.
     */
    private static final double LEAST_SHIFT_PX = 0.5;
    private static final double MOST_SHIFT_PX = 3;
    /**
     * Shift of the ends of the window by the first step towards that velocity, in px, below which the part moves with
     * the rest. This spares most parts two fits.
     */
    private static final double LEAST_FIRST_PX = 0.25;
    /** Step, in px, by which events are projected. */
    private static final double STEP_PX = 1.0 / 32;
    private static final int NOWHERE = -1;
    private static final int NONE = 0;

    private final int columns;
    private final int rows;
    /** Events of each cell, and the part that the cell belongs to, from 1 on; {@link #NONE} for none. */
    private final int[] events;
    private final int[] parts;
    /** Events of each part. */
    private final int[] sizes;
    /** Cells of a part whose neighbours have not been visited yet. */
    private final int[] waiting;
    /** Box around the cells that have events: a small structure covers few cells of a large sensor. */
    private final PixelBox box = new PixelBox();
    /** Cell of each live event, by its index. */
    private final int[] cells = new int[LiveEvents.CAPACITY];
    private final Motion along = new Motion();
    private final SteppedProjection stepped = new SteppedProjection();
    /** The part that was found last. */
    private int found;
    private final OwnVelocity own = new OwnVelocity();
    private final TwoBodies two;
    private boolean areTwo;
    /** Motions of the part that was found last, and of the structure without that part. */
    private final Motion motionOfPart = new Motion();
    private final Motion rest = new Motion();

    Parting(SensorSize sensor, TiledEvents tiled) {
        two = new TwoBodies(tiled);
        columns = cells(sensor.width());
        rows = cells(sensor.height());
        events = new int[columns * rows];
        parts = new int[columns * rows];
        sizes = new int[columns * rows + 1];
        waiting = new int[columns * rows];
    }

    private static int cells(int px) {
        return (px - 1 >> CELL_BITS) + 1 + 2 * MARGIN;
    }

    /** Bytes of its arrays. */
    static long bytes(SensorSize sensor) {
        return Integer.BYTES * (4L * cells(sensor.width()) * cells(sensor.height()) + LiveEvents.CAPACITY)
            + TwoBodies.bytes(sensor);
    }

    /** Motion of the part that was found last, in the middle of the window of the live events. */
    Motion motionOfPart() {
        return motionOfPart;
    }

    /** Motion of the structure without that part. */
    Motion rest() {
        return rest;
    }

    /** Whether a live event, by its index, belongs to the part that was found last. */
    boolean isOfPart(int i) {
        return areTwo ? two.isOfSmaller(i) : found != NONE && isOf(found, i);
    }

    private boolean isOf(int part, int i) {
        return cells[i] != NOWHERE && parts[cells[i]] == part;
    }

    /**
     * Looks for the part that lies apart from the others and is most clearly a body of its own.
     *
     * @param live the events of the structure, of all tiles
     * @param motion of the structure
     * @param radius of the structure in px
     * @return whether there is one
     */
    boolean findApart(LiveEvents live, Motion motion, double radius, MetricFit fit) {
        found = NONE;
        areTwo = false;
        long windowUs = live.newestUs() - live.oldestUs();
        if (windowUs <= 0) {
            return false;
        }
        along.copyFrom(motion);
        along.moveReference(live.middleUs());
        layOnCells(live, radius);
        int count = connect();
        int largest = 1;
        for (int k = 2; k <= count; k++) {
            largest = sizes[k] > sizes[largest] ? k : largest;
        }
        double clearest = SHOWN_SIGMAS;
        for (int part = 1; part <= count; part++) {
            if (part != largest && sizes[part] >= LEAST_EVENTS && sizes[part] <= fit.capacity()) {
                double sigmas = sigmasGained(part, live, radius, windowUs * 0.5e-6, fit);
                if (sigmas > clearest) {
                    clearest = sigmas;
                    found = part;
                    motionOfPart.set(along.referenceUs, along.vx + own.vx(), along.vy + own.vy());
                }
            }
        }
        rest.copyFrom(motion);
        return found != NONE;
    }

    /**
     * Looks for two bodies that seem to turn or grow together. The one with fewer events is the part.
     *
     * @param motion of the structure
     * @return whether there are two
     */
    boolean findTwo(LiveEvents live, Motion motion, double radius, MetricFit fit) {
        found = NONE;
        areTwo = live.newestUs() > live.oldestUs() && two.find(live, motion, radius, fit);
        if (areTwo) {
            motionOfPart.copyFrom(two.smaller());
            rest.copyFrom(two.larger());
        }
        return areTwo;
    }

    /**
     * Whether the structure that {@link #findTwo} examined last turned or grew enough for two bodies to look like it.
     */
    boolean turns() {
        return two.turns();
    }

    /** Whether the structure that {@link #findTwo} examined last clearly turned or grew as one body. */
    boolean isClearlyOne() {
        return two.isClearlyOne();
    }

    private void begin(LiveEvents live, double radius) {
        stepped.begin(along, along.referenceUs - live.oldestUs(), 2 * radius, STEP_PX);
    }

    /** Notes the cell that each event falls on, and counts the events of each cell that the structure alone claims. */
    private void layOnCells(LiveEvents live, double radius) {
        wipe();
        begin(live, radius);
        for (int k = 0; k < live.size(); k++) {
            int i = live.index(k);
            stepped.advance(live.timeUs[i]);
            int column = ((int) Math.floor(stepped.x(live.x[i], live.y[i])) >> CELL_BITS) + MARGIN;
            int row = ((int) Math.floor(stepped.y(live.x[i], live.y[i])) >> CELL_BITS) + MARGIN;
            // the outermost cells stay empty, so that each cell has neighbours
            boolean isInside = column > 0 && row > 0 && column < columns - 1 && row < rows - 1;
            cells[i] = isInside ? row * columns + column : NOWHERE;
            if (isInside && live.claim(i) == Claim.OWN) {
                events[cells[i]]++;
                box.add(column, row);
            }
        }
    }

    /** Forgets events and parts. */
    private void wipe() {
        for (int row = box.top; row <= box.bottom; row++) {
            Arrays.fill(events, row * columns + box.left, row * columns + box.right + 1, 0);
            Arrays.fill(parts, row * columns + box.left, row * columns + box.right + 1, NONE);
        }
        box.clear();
    }

    /** Numbers the parts, which are groups of touching cells with events. Returns how many parts there are. */
    private int connect() {
        int count = 0;
        for (int row = box.top; row <= box.bottom; row++) {
            for (int cell = row * columns + box.left; cell <= row * columns + box.right; cell++) {
                if (isFree(cell)) {
                    sizes[++count] = spread(cell, count);
                }
            }
        }
        return count;
    }

    private boolean isFree(int cell) {
        return events[cell] >= LEAST_IN_CELL && parts[cell] == NONE;
    }

    /** Gives a number to all cells that are connected to a first cell. Returns how many events they have. */
    private int spread(int first, int number) {
        int size = 0;
        int open = 0;
        parts[first] = number;
        waiting[open++] = first;
        while (open > 0) {
            int cell = waiting[--open];
            size += events[cell];
            for (int row = cell - columns; row <= cell + columns; row += columns) {
                for (int next = row - 1; next <= row + 1; next++) {
                    if (isFree(next)) {
                        parts[next] = number;
                        waiting[open++] = next;
                    }
                }
            }
        }
        return size;
    }

    /**
     * Gain of the metric of a part by the velocity that suits it best, in standard deviations. The gain is 0 where that
     * velocity is about the common one, or too far from it.
     */
    private double sigmasGained(int part, LiveEvents live, double radius, double half, MetricFit fit) {
        fit.clear();
        begin(live, radius);
        for (int k = 0; k < live.size(); k++) {
            int i = live.index(k);
            if (isOf(part, i) && live.claim(i) == Claim.OWN) {
                stepped.advance(live.timeUs[i]);
                fit.add((float) stepped.x(live.x[i], live.y[i]), (float) stepped.y(live.x[i], live.y[i]),
                    (live.timeUs[i] - along.referenceUs) * 1e-6f, 0, 0, live.sign[i]);
            }
        }
        double common = fit.metric();
        own.begin(fit, half);
        if (own.shiftPx(half) < LEAST_FIRST_PX) {
            return 0;
        }
        double metric = own.goOn(fit, half);
        double shift = own.shiftPx(half);
        return shift < LEAST_SHIFT_PX || shift > MOST_SHIFT_PX ? 0 : (metric - common) / MetricFit.sd(metric);
    }
}
