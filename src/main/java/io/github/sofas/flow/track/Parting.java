package io.github.sofas.flow.track;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.motion.Motion;
import io.github.sofas.flow.motion.PixelBox;
import io.github.sofas.flow.motion.SteppedProjection;
import java.util.Arrays;

/**
 * Whether a part of a track plane is a body of its own: of its live events, laid on each other along its motion, those
 * that lie apart from the others, if another velocity makes them sharper beyond doubt; or else one of two bodies that
 * seem to turn or grow together ({@link TwoBodies}).
 *
 * <p>Ours, because two bodies that moved about alike when they were found, or merged, have one motion from then on that
 * is right for neither, and each measurement finds the best one for both.
 */
final class Parting {
    /** Side of the cells that events lie apart by, in px, as a power of two. */
    private static final int CELL_BITS = 2;
    /** Cells around the sensor: along its motion an event may lie outside. */
    private static final int MARGIN = 8;
    /** Events of a cell that belongs to a body: a lone one is noise. */
    private static final int LEAST_IN_CELL = 2;
    /** Fewest events of a part that is looked at. */
    private static final int LEAST_EVENTS = 60;
    /** Standard deviations that the metric of a part must gain by a velocity of its own. */
    private static final double SHOWN_SIGMAS = 7;
    /** What it shifts the ends of the window by, in px, at least, and at most: farther off are false tops. */
    private static final double LEAST_SHIFT_PX = 0.5;
    private static final double MOST_SHIFT_PX = 3;
    /** Shift by the first step towards it below which the part moves with the rest, which spares most two fits. */
    private static final double LEAST_FIRST_PX = 0.25;
    /** Events are projected in steps of this part of a pixel. */
    private static final double STEP_PX = 1.0 / 32;
    private static final int NOWHERE = -1;
    private static final int NONE = 0;

    private final int columns;
    private final int rows;
    /** Events of each cell, and the part that it is of, from 1 on; {@link #NONE} for none. */
    private final int[] events;
    private final int[] parts;
    /** Events of each part. */
    private final int[] sizes;
    /** Cells of a part whose neighbours are not looked at yet. */
    private final int[] waiting;
    /** Around the cells that have any events: of a large sensor, a small structure has few. */
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
    /** Motions of the part that was found last, and of what is left without it. */
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

    /** Whether a live event, by its index, is one of the part that was found last. */
    boolean isOfPart(int i) {
        return areTwo ? two.isOfSmaller(i) : found != NONE && isOf(found, i);
    }

    private boolean isOf(int part, int i) {
        return cells[i] != NOWHERE && parts[cells[i]] == part;
    }

    /**
     * Looks for the part, lying apart from the others, that is a body of its own most clearly.
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
     * Looks for two bodies that seem to turn or grow together, of which the one with fewer events is the part.
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

    /** Whether the structure of which it was asked last whether it is two turned or grew enough to seem so. */
    boolean turns() {
        return two.turns();
    }

    /** Whether the structure of which it was asked last whether it is two clearly turned or grew as one. */
    boolean isClearlyOne() {
        return two.isClearlyOne();
    }

    private void begin(LiveEvents live, double radius) {
        stepped.begin(along, along.referenceUs - live.oldestUs(), 2 * radius, STEP_PX);
    }

    /** Notes on which cell each event falls, and counts those of each cell that the structure alone claims. */
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

    /** Numbers the parts: cells with events that touch; returns how many there are. */
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

    /** Gives a number to all cells that are connected to one; returns how many events they have. */
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

    /** What the metric of the part gains by the velocity that suits it best; nothing where that is about the same. */
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
