package io.github.sofas.flow.track;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.PixelConsumer;
import io.github.sofas.flow.motion.Bounds;
import io.github.sofas.flow.motion.Motion;
import io.github.sofas.flow.motion.SteppedProjection;

/**
 * The contour of a track plane: where in its frame its events fell of late (paper, section Track Plane). An event lies
 * on it that has enough support by {@link ContourCells}.
 *
 * <p>Ours: events are let go by sixteenths of the time for which they are held, mostly the lifetime, instead of one by
 * one, and stay where they are when the motion is known a little better. So a label costs the same at any density, and
 * all else is paid per travel.
 */
final class Contour {
    /** Departure of the frame from the sensor at which it is anchored anew, in px; less than the margin. */
    private static final double FARTHEST_PX = 12;
    /** Least shift over the lifetime by a correction of the motion for the contour to be drawn anew, in px. */
    static final double REDRAWN_PX = 0.5;
    /** Room around the box that the contour does not leave, for the frame's steps and for what is rounded, in px. */
    private static final double REACH_ROOM_PX = 1;
    /** Distance from the border of the sensor within which the contour may be cut off by it, in px. */
    private static final double BORDER_PX = 2;
    /** Live events are projected onto it in steps of this part of a pixel. */
    static final double PROJECTED_STEP_PX = 1.0 / 16;
    /** Steps in which it is looked for ahead of a place, in px. */
    private static final double STEP_PX = 4;
    /** Breadth of what is wide, as a share of the sensor's shorter side: all of that has 0.29. */
    private static final double WIDE = 0.2;

    private final int sensorWidth;
    private final int sensorHeight;
    private ContourCells cells;
    /** Cells to anchor anew with, of any contour. */
    private final Spare spare;
    private final Frame frame = new Frame();
    private final SteppedProjection past = new SteppedProjection();
    private long fadedUs;
    /** Place in the frame of the event whose support was asked for last. */
    private double lastX;
    private double lastY;
    /** Whether events of either polarity are expected where those of one were seen. */
    private boolean expectsEither;

    private final ContourFigures figures = new ContourFigures();
    private final Bounds box = new Bounds();
    private final Bounds reached = new Bounds();
    /** Whether it may lie elsewhere than was told last. */
    private boolean changedReach;

    /** Empty cells that contours of one sensor use in turn while they are anchored anew. */
    static final class Spare {
        private ContourCells cells;

        Spare(SensorSize sensor) {
            cells = new ContourCells(sensor);
        }
    }

    Contour(SensorSize sensor, Spare spare) {
        this.spare = spare;
        sensorWidth = sensor.width();
        sensorHeight = sensor.height();
        cells = new ContourCells(sensor);
    }

    /** Bytes of its arrays. */
    static long bytes(SensorSize sensor) {
        return ContourCells.bytes(sensor);
    }

    /** Begins without events, along a motion. */
    void start(Motion along) {
        wipe();
        frame.anchor(along, 0);
        fadedUs = along.referenceUs;
        expectsEither = false;
        figures.start();
    }

    /** Least support that puts an event on the contour. */
    int threshold() {
        return figures.threshold();
    }

    /** Close support below which it is doubtful whether an event is of the structure. */
    double sureSupport() {
        return figures.sureSupport();
    }

    /** Centre of the contour at the last {@link #measure}, x in px of the sensor. */
    double centreX() {
        return figures.centreX();
    }

    double centreY() {
        return figures.centreY();
    }

    /** Distance of the contour from its centre, root of the mean square, in px. */
    double radius() {
        return figures.radius();
    }

    /** Its standard deviation along the axis in which it is narrowest, in px: that of a square by 0.29 of its side. */
    double breadth() {
        return figures.breadth();
    }

    /** Whether it fills the picture from side to side, as a wall does: no bar is as broad. */
    boolean isWide() {
        return breadth() >= WIDE * Math.min(sensorWidth, sensorHeight);
    }

    /** Expects events of either polarity where those of one were seen, or of that one alone. */
    void expectEither(boolean either) {
        expectsEither = either;
    }

    private int expected(int polarity) {
        return expectsEither ? ContourCells.EITHER : polarity;
    }

    /** Support of an event by the events of late around its cell. */
    int support(int x, int y, long timeUs, int polarity) {
        frame.advance(timeUs);
        lastX = frame.x(x, y);
        lastY = frame.y(x, y);
        return cells.support(ContourCells.cell(lastX), ContourCells.cell(lastY), expected(polarity));
    }

    /** Whether some of it lies a step or two ahead of a place, the way that it moves. */
    boolean goesOnFrom(int x, int y, long timeUs) {
        double vx = frame.motion().vxAt(x, y, timeUs);
        double vy = frame.motion().vyAt(x, y, timeUs);
        double stepS = PixelHistory.travelS(STEP_PX, vx, vy);
        int dx = (int) Math.rint(stepS * vx);
        int dy = (int) Math.rint(stepS * vy);
        return isOn(x + dx, y + dy, timeUs) || isOn(x + 2 * dx, y + 2 * dy, timeUs);
    }

    /** Whether an event of either polarity would be on it. */
    private boolean isOn(int x, int y, long timeUs) {
        return support(x, y, timeUs, 1) >= threshold() || support(x, y, timeUs, -1) >= threshold();
    }

    /**
     * A box of the sensor, as {@link Reaches} has them, beyond which no event has support until a time, unless the
     * contour grows or follows another motion; {@link #hasChangedReach} tells that.
     */
    long reach(long nowUs, long untilUs) {
        changedReach = false;
        if (isEmpty()) {
            return Reaches.NOWHERE;
        }
        frame.advance(nowUs);
        reached.clear();
        double speed = 0;
        for (int corner = 0; corner < 4; corner++) {
            double inFrameX = ((corner & 1) == 0 ? cells.minX() - 0.5 : cells.maxX() + 0.5) - ContourCells.MARGIN;
            double inFrameY = ((corner & 2) == 0 ? cells.minY() - 0.5 : cells.maxY() + 0.5) - ContourCells.MARGIN;
            double x = frame.sensorX(inFrameX, inFrameY);
            double y = frame.sensorY(inFrameX, inFrameY);
            reached.include(x, y);
            speed = Math.max(speed, frame.motion().mostSpeed(x, y, nowUs, untilUs));
        }
        double room = REACH_ROOM_PX + speed * (untilUs - nowUs) * 1e-6;
        return Reaches.box(reached.left() - room, reached.top() - room, reached.right() + room,
            reached.bottom() + room);
    }

    /** Whether it has grown or followed another motion since its reach was asked for. */
    boolean hasChangedReach() {
        return changedReach;
    }

    /** Support by the cells nearest, of the event whose support was asked for last and that has any. */
    int closeSupport(int polarity) {
        return cells.closeSupport(ContourCells.firstOfTwo(lastX), ContourCells.firstOfTwo(lastY), expected(polarity));
    }

    /**
     * Notes an event on its cell.
     *
     * @param ageUs how long ago it was, of the time for which events are held
     */
    void add(int x, int y, long timeUs, int polarity, long ageUs, long heldUs) {
        frame.advance(timeUs);
        changedReach |= cells.see(frame.x(x, y), frame.y(x, y), polarity, sixteenths(ageUs, heldUs));
    }

    private static int sixteenths(long ageUs, long heldUs) {
        return (int) Math.min(ContourCells.SIXTEENTHS, ageUs * ContourCells.SIXTEENTHS / Math.max(1, heldUs));
    }

    /** Notes the event whose support was asked for last, as one of now. */
    void addLast(int polarity) {
        changedReach |= cells.see(lastX, lastY, polarity, 0);
    }

    /** Lets go what is older than the time for which events are held. */
    void fade(long nowUs, long heldUs) {
        long dueUs = Math.max(1, heldUs / ContourCells.SIXTEENTHS);
        if (isEmpty()) {
            fadedUs = nowUs;
        }
        if (nowUs - fadedUs >= dueUs) {
            cells.pass((int) Math.min(ContourCells.SIXTEENTHS, (nowUs - fadedUs) / dueUs));
            fadedUs = nowUs;
        }
    }

    /** Follows another motion from its reference on. */
    void follow(Motion along) {
        changedReach = true;
        frame.follow(along, radius());
        if (!isEmpty() && (departurePx(cells.minX(), cells.minY()) > FARTHEST_PX
                || departurePx(cells.maxX(), cells.maxY()) > FARTHEST_PX)) {
            anchor();
        }
    }

    /** How far the frame lies from the sensor at a cell. */
    private double departurePx(int cx, int cy) {
        return frame.departurePx(frame.toReferenceX(cx - ContourCells.MARGIN, cy - ContourCells.MARGIN),
            frame.toReferenceY(cx - ContourCells.MARGIN, cy - ContourCells.MARGIN));
    }

    /** Anchors the frame anew: each cell takes over what was seen by the cell that was where it is. */
    private void anchor() {
        ContourCells from = cells;
        cells = spare.cells;
        spare.cells = from;
        if (frame.isOnlyShifted()) {
            int dx = (int) Math.rint(frame.shiftX());
            int dy = (int) Math.rint(frame.shiftY());
            cells.takeShifted(from, dx, dy);
            frame.shift(-dx, -dy);
        } else {
            cells.takeTurned(from, frame);
            frame.anchorAgain();
        }
        from.wipe();
    }

    /** Takes over what was seen by another contour of the sensor, cell by cell; both follow a motion from then on. */
    void absorb(Contour other, Motion along) {
        changedReach = true;
        frame.follow(along, radius());
        other.frame.follow(along, other.radius());
        cells.absorb(other.cells, other.frame, frame);
    }

    /** Draws the contour anew from the live events, along a motion. */
    void draw(LiveEvents live, Motion along, long heldUs) {
        wipe();
        frame.anchor(along, radius());
        fadedUs = along.referenceUs;
        if (live.size() == 0) {
            return;
        }
        past.begin(along, along.referenceUs - live.oldestUs(), 2 * radius(), PROJECTED_STEP_PX);
        for (int k = 0; k < live.size(); k++) {
            int i = live.index(k);
            past.advance(live.timeUs[i]);
            cells.see(past.x(live.x[i], live.y[i]), past.y(live.x[i], live.y[i]), live.sign[i],
                sixteenths(along.referenceUs - live.timeUs[i], heldUs));
        }
    }

    /** Empties all cells. */
    void wipe() {
        changedReach = true;
        cells.wipe();
    }

    /**
     * Measures threshold, centre, radius and breadth from some of the live events.
     *
     * @param along the motion that the contour follows, with its reference at now
     * @param noiseSupport support that noise may have
     */
    void measure(LiveEvents live, Motion along, int noiseSupport) {
        figures.measure(cells, frame, live, along, expectsEither, noiseSupport);
    }

    /** Whether an event of either polarity on an occupied cell is on the contour. */
    private boolean isContour(int cx, int cy) {
        return cells.isOccupied(cx, cy) && cells.support(cx, cy, ContourCells.EITHER) >= threshold();
    }

    /** Shows the occupied cells that would put an event of either polarity on the contour, carried on to a time. */
    void show(long nowUs, PixelConsumer pixels) {
        Motion motion = frame.motion();
        double dt = (nowUs - motion.referenceUs) * 1e-6;
        for (int cy = cells.minY(); cy <= cells.maxY(); cy++) {
            for (int cx = cells.minX(); cx <= cells.maxX(); cx++) {
                if (isContour(cx, cy)) {
                    double px = frame.toReferenceX(cx - ContourCells.MARGIN, cy - ContourCells.MARGIN);
                    double py = frame.toReferenceY(cx - ContourCells.MARGIN, cy - ContourCells.MARGIN);
                    int x = (int) Math.rint(px + dt * motion.vxAt((int) px, (int) py, motion.referenceUs));
                    int y = (int) Math.rint(py + dt * motion.vyAt((int) px, (int) py, motion.referenceUs));
                    if (x >= 0 && x < sensorWidth && y >= 0 && y < sensorHeight) {
                        pixels.accept(x, y);
                    }
                }
            }
        }
    }

    /** Its box at a time, in px of the sensor, which it may leave; until it is asked for again. Not of an empty one. */
    Bounds box(long nowUs) {
        Motion motion = frame.motion();
        double travelX = motion.vx * (nowUs - motion.referenceUs) * 1e-6;
        double travelY = motion.vy * (nowUs - motion.referenceUs) * 1e-6;
        box.set(edgeX(cells.minX() + 1) + travelX, edgeY(cells.minY() + 1) + travelY,
            edgeX(cells.maxX() - 1) + travelX, edgeY(cells.maxY() - 1) + travelY);
        return box;
    }

    private double edgeX(int cx) {
        return frame.toReferenceX(cx - ContourCells.MARGIN, (cells.minY() + cells.maxY()) / 2.0 - ContourCells.MARGIN);
    }

    private double edgeY(int cy) {
        return frame.toReferenceY((cells.minX() + cells.maxX()) / 2.0 - ContourCells.MARGIN, cy - ContourCells.MARGIN);
    }

    /** Whether a place of the sensor lies in its box, or beside it by so many px at most. */
    boolean isAround(int x, int y, double marginPx, long nowUs) {
        return !isEmpty() && box(nowUs).isAround(x, y, marginPx);
    }

    /** Widens a box so that it holds its own. */
    void includeIn(Bounds other, long nowUs) {
        if (!isEmpty()) {
            Bounds its = box(nowUs);
            other.include(its.left(), its.top());
            other.include(its.right(), its.bottom());
        }
    }

    /** Whether its box and that of another contour lie no farther apart than a gap in px, along both axes. */
    boolean isWithin(double gap, Contour other, long nowUs) {
        return box(nowUs).isWithin(gap, other.box(nowUs));
    }

    /** Whether all of it lies within the sensor, and none so near the border that more may lie beyond. */
    boolean isInside(long nowUs) {
        Bounds its = box(nowUs);
        return !isEmpty() && its.left() > BORDER_PX && its.top() > BORDER_PX
            && its.right() < sensorWidth - 1 - BORDER_PX && its.bottom() < sensorHeight - 1 - BORDER_PX;
    }

    /** Whether all of it lies beyond the sensor. */
    boolean hasLeft(long nowUs) {
        Bounds its = box(nowUs);
        return !isEmpty() && (its.right() < 0 || its.left() >= sensorWidth || its.bottom() < 0
            || its.top() >= sensorHeight);
    }

    /** Whether no cell is occupied. */
    boolean isEmpty() {
        return cells.isEmpty();
    }

    /** Longer side of the box in px. */
    int extent() {
        return Math.max(cells.maxX() - cells.minX(), cells.maxY() - cells.minY()) - 2;
    }
}
