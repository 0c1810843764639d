package io.github.sofas.flow.track;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.PixelConsumer;
import io.github.sofas.flow.motion.Bounds;
import io.github.sofas.flow.motion.Motion;
import io.github.sofas.flow.motion.SteppedProjection;

/**
 * The contour of a track plane: the places in its frame where its events fell recently (paper, section Track Plane). An
 * event lies on the contour if it has enough support by the {@link ContourCells}.
 *
 * <p>Ours: the contour drops events by sixteenths of the time for which it holds them, mostly the lifetime, instead of
 * one by one. Events also stay on their cells when the motion becomes a little better known. A label therefore costs
 * the same at any event density, and all other costs are per travel.
 */
final class Contour {
    /** Departure of the frame from the sensor at which the frame is anchored anew, in px; less than the margin. */
    private static final double FARTHEST_PX = 12;
    /** Shift over half the lifetime, by a correction of the motion, beyond which the contour is drawn anew, in px. */
    static final double REDRAWN_PX = 0.5;
    /** Extra room around the box of {@link #reach}, for the steps of the frame and for rounding, in px. */
    private static final double REACH_ROOM_PX = 1;
    /** Least share of the contour's box on the sensor of what is in sight: the border hides few of its events. */
    private static final double IN_SIGHT = 0.8;
    /** Step, in px, by which live events are projected onto the contour. */
    static final double PROJECTED_STEP_PX = 1.0 / 16;
    /** Step, in px, of the search for more of the contour ahead of a place. */
    private static final double STEP_PX = 4;
    /** Breadth from which on a contour is wide, as a share of the sensor's shorter side; all of that side has 0.29. */
    private static final double WIDE = 0.2;

    private final int sensorWidth;
    private final int sensorHeight;
    private ContourCells cells;
    /** Empty cells for anchoring anew, shared by the contours of a sensor. */
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
    /** Whether the contour may have left the box that {@link #reach} returned last. */
    private boolean changedReach;

    /** Empty cells that the contours of one sensor use in turn while they are anchored anew. */
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

    /** Bytes that the arrays take. */
    static long bytes(SensorSize sensor) {
        return ContourCells.bytes(sensor);
    }

    /** Starts without events, along a motion. */
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

    /** Close support below which it is doubtful whether an event belongs to the structure. */
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

    /** Root mean square distance of the contour from its centre, in px. */
    double radius() {
        return figures.radius();
    }

    /** Standard deviation of the contour along its narrowest axis, in px; a square has 0.29 of its side. */
    double breadth() {
        return figures.breadth();
    }

    /** Whether the contour fills the picture from side to side, as a wall does: no bar is as broad. */
    boolean isWide() {
        return breadth() >= WIDE * Math.min(sensorWidth, sensorHeight);
    }

    /** Sets whether events of either polarity are expected where one polarity was seen, or of that polarity alone. */
    void expectEither(boolean either) {
        expectsEither = either;
    }

    private int expected(int polarity) {
        return expectsEither ? ContourCells.EITHER : polarity;
    }

    /** Returns the support of an event by the recent events around its cell. */
    int support(int x, int y, long timeUs, int polarity) {
        frame.advance(timeUs);
        lastX = frame.x(x, y);
        lastY = frame.y(x, y);
        return cells.support(ContourCells.cell(lastX), ContourCells.cell(lastY), expected(polarity));
    }

    /** Returns the time in µs since a place of the structure, if it came in over the border, was at the border. */
    double inSightUs(int x, int y, long timeUs) {
        Motion motion = frame.motion();
        return 1e6 * Math.min(sinceBorderS(x, motion.vxAt(x, y, timeUs), sensorWidth),
            sinceBorderS(y, motion.vyAt(x, y, timeUs), sensorHeight));
    }

    /** The same in s along one axis of the sensor; infinite for what does not move along it. */
    private static double sinceBorderS(int place, double pxPerS, int side) {
        double travelledPx = pxPerS > 0 ? place + 0.5 : place + 0.5 - side;
        return pxPerS == 0 ? Double.POSITIVE_INFINITY : travelledPx / pxPerS;
    }

    /** Whether some of the contour lies a step or two ahead of a place, in the direction of its motion. */
    boolean goesOnFrom(int x, int y, long timeUs) {
        double vx = frame.motion().vxAt(x, y, timeUs);
        double vy = frame.motion().vyAt(x, y, timeUs);
        double stepS = PixelHistory.travelS(STEP_PX, vx, vy);
        int dx = (int) Math.rint(stepS * vx);
        int dy = (int) Math.rint(stepS * vy);
        return isOn(x + dx, y + dy, timeUs) || isOn(x + 2 * dx, y + 2 * dy, timeUs);
    }

    /** Whether an event of one polarity or the other would lie on the contour. */
    private boolean isOn(int x, int y, long timeUs) {
        return support(x, y, timeUs, 1) >= threshold() || support(x, y, timeUs, -1) >= threshold();
    }

    /**
     * Returns a box of the sensor, in the format of {@link Reaches}, beyond which no event has support until a time.
     * The box holds unless the contour grows or follows another motion, which {@link #hasChangedReach} reports.
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

    /** Whether the contour has grown or followed another motion since the last {@link #reach}. */
    boolean hasChangedReach() {
        return changedReach;
    }

    /** Returns the support by the four nearest cells of the event whose support was asked for last, if it had any. */
    int closeSupport(int polarity) {
        return cells.closeSupport(ContourCells.firstOfTwo(lastX), ContourCells.firstOfTwo(lastY), expected(polarity));
    }

    /**
     * Notes an event on its cell.
     *
     * @param ageUs age of the event, to be compared with the time for which events are held
     */
    void add(int x, int y, long timeUs, int polarity, long ageUs, long heldUs) {
        see(x, y, timeUs, polarity, sixteenths(ageUs, heldUs));
    }

    /** Notes a current event on its cell. */
    void add(int x, int y, long timeUs, int polarity) {
        see(x, y, timeUs, polarity, 0);
    }

    private void see(int x, int y, long timeUs, int polarity, int age) {
        frame.advance(timeUs);
        changedReach |= cells.see(frame.x(x, y), frame.y(x, y), polarity, age);
    }

    private static int sixteenths(long ageUs, long heldUs) {
        return (int) Math.min(ContourCells.SIXTEENTHS, ageUs * ContourCells.SIXTEENTHS / Math.max(1, heldUs));
    }

    /** Notes the event whose support was asked for last, with age 0. */
    void addLast(int polarity) {
        changedReach |= cells.see(lastX, lastY, polarity, 0);
    }

    /** Drops events that are older than the time for which events are held. */
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

    /** Distance of the frame from the sensor at a cell, in px. */
    private double departurePx(int cx, int cy) {
        return frame.departurePx(frame.toReferenceX(cx - ContourCells.MARGIN, cy - ContourCells.MARGIN),
            frame.toReferenceY(cx - ContourCells.MARGIN, cy - ContourCells.MARGIN));
    }

    /** Anchors the frame anew. Each cell takes over the events of the old cell at its place. */
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

    /** Takes over the events of another contour of the sensor, cell by cell. Both follow a motion from then on. */
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
     * @param along the motion that the contour follows, with the current time as its reference
     * @param noiseSupport support that noise may have
     */
    void measure(LiveEvents live, Motion along, int noiseSupport) {
        figures.measure(cells, frame, live, along, expectsEither, noiseSupport);
    }

    /** Whether a cell is occupied, and would put an event of one polarity or the other on the contour. */
    private boolean isContour(int cx, int cy) {
        return cells.isOccupied(cx, cy) && cells.support(cx, cy, ContourCells.EITHER) >= threshold();
    }

    /** Shows the occupied cells that would put an event on the contour, moved on to a time. */
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

    /**
     * Returns the box of the contour at a time, in px of the sensor. The box may reach beyond the sensor; that of an
     * empty contour has no meaning. The returned object is reused by the next call.
     */
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

    /** Whether a place of the sensor lies in the box of the contour, or within a margin of it. */
    boolean isAround(int x, int y, double marginPx, long nowUs) {
        return !isEmpty() && box(nowUs).isAround(x, y, marginPx);
    }

    /** Widens a box so that it holds the box of the contour. */
    void includeIn(Bounds other, long nowUs) {
        if (!isEmpty()) {
            Bounds its = box(nowUs);
            other.include(its.left(), its.top());
            other.include(its.right(), its.bottom());
        }
    }

    /** Whether the boxes of this and another contour lie no farther apart than a gap in px, along both axes. */
    boolean isWithin(double gap, Contour other, long nowUs) {
        return box(nowUs).isWithin(gap, other.box(nowUs));
    }

    /**
     * Whether most of the contour lies on the sensor, by its box: what fills the picture, as a wall or a digit on a
     * small sensor does, always reaches beyond.
     */
    boolean isInSight(long nowUs) {
        return !isEmpty() && box(nowUs).shareOn(sensorWidth, sensorHeight) >= IN_SIGHT;
    }

    /** Whether the whole contour lies beyond the sensor. */
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
