package io.github.sofas.flow.fit;

/**
 * The metric of a set of events under motions beside the one that they were projected along (paper, section Structure
 * Detection). Each event is shifted by the difference in a parameter of the motion, times its shift per unit of the
 * parameter ({@link ShiftProfile}). The shifted events then vote in the {@link BilinearAccumulator}.
 */
final class Metric {
    private static final int EVENT_BYTES = 18 * Integer.BYTES;

    /** Events, projected along the motion. */
    private final BilinearAccumulator grid;
    // of each event: time from the reference in s, and place from the centre of rotation in px
    private final float[] tau;
    private final float[] fromX;
    private final float[] fromY;
    /** Tiles of the structure, and whether they are those of the present events. */
    private final Tiles tiles;
    private boolean tiled;
    // shifts by parameters of the motion: time, its square, place from the centre, and place times time; all but those
    // by time are computed on demand
    private final ShiftProfile time;
    private final ShiftProfile square;
    private final ShiftProfile placeX;
    private final ShiftProfile placeY;
    private final ShiftProfile timeX;
    private final ShiftProfile timeY;
    /** Place that stays fixed under growth, in px from the centre. */
    private double growsFromX;
    private double growsFromY;
    private boolean laid;
    private boolean squared;
    private boolean placed;
    private final float[] shift;
    private final ShiftProfile alongX;
    private final ShiftProfile alongY;

    Metric(int sensorWidth, int sensorHeight, double cellPx, int capacity, int mostOnBoth) {
        grid = new BilinearAccumulator(sensorWidth, sensorHeight, cellPx, capacity, mostOnBoth);
        tau = new float[capacity];
        fromX = new float[capacity];
        fromY = new float[capacity];
        shift = new float[capacity];
        tiles = new Tiles(capacity);
        time = new ShiftProfile(capacity);
        square = new ShiftProfile(capacity);
        placeX = new ShiftProfile(capacity);
        placeY = new ShiftProfile(capacity);
        timeX = new ShiftProfile(capacity);
        timeY = new ShiftProfile(capacity);
        alongX = new ShiftProfile(capacity);
        alongY = new ShiftProfile(capacity);
    }

    /** Bytes of the arrays for up to a number of events. */
    static long bytes(int sensorWidth, int sensorHeight, double cellPx, int capacity) {
        return BilinearAccumulator.bytes(sensorWidth, sensorHeight, cellPx) + (long) capacity * EVENT_BYTES;
    }

    int capacity() {
        return grid.capacity();
    }

    int size() {
        return grid.size();
    }

    long votes() {
        return grid.votes();
    }

    void clear() {
        grid.clear();
        growFrom(0, 0);
    }

    /** Measures growth from a place, in px from the centre, until the events are forgotten. */
    void growFrom(double x, double y) {
        growsFromX = x;
        growsFromY = y;
    }

    /**
     * Accounts for a border that cuts off the events, which move at (vx, vy) px/s in a window of twice {@code half}.
     */
    void cutOff(double vx, double vy, double half) {
        grid.inSight().cutOff(vx, vy, half);
    }

    /** Whether the border cuts the events off. */
    boolean isCutOff() {
        return grid.inSight().isCutOff();
    }

    void add(float x, float y, float tauS, float rx, float ry, int polarity) {
        int i = grid.size();
        grid.add(x, y, polarity);
        tau[i] = tauS;
        fromX[i] = rx;
        fromY[i] = ry;
        laid = false;
    }

    /** Prepares the added events for their first metric. */
    void lay() {
        if (laid) {
            return;
        }
        grid.lay();
        time.take(tau, grid.size());
        laid = true;
        squared = false;
        placed = false;
        tiled = false;
    }

    /** Sums how the picture of the events changes with place; the structure has so many px of radius. */
    void structure(StructureTensor tensor, double radius) {
        grid.structure(tensor, grid.x(0) - fromX[0], grid.y(0) - fromY[0], radius);
    }

    /** Metric of the events moved back by velocity (vx, vy) in px/s. */
    double atVelocity(double vx, double vy) {
        return grid.metric(time, vx, time, vy, vx, vy);
    }

    /** Slopes of the metric by each parameter of the motion; all 0 without events. */
    void slopes(MetricSlopes to) {
        if (size() == 0) {
            to.clear();
            return;
        }
        lay();
        grid.slopes(time, grid.x(0) - fromX[0], grid.y(0) - fromY[0], to);
    }

    /** Metric of the events moved back by velocity (vx, vy) in px/s, whatever the border cuts off. */
    double asSeen(double vx, double vy) {
        grid.inSight().pause(true);
        double metric = atVelocity(vx, vy);
        grid.inSight().pause(false);
        return metric;
    }

    /** Metrics at accelerations of h px/s² less and more along (dirX, dirY). */
    void alongAcceleration(double dirX, double dirY, double h, double[] lessAndMore) {
        takeSquare();
        lessAndMore(square, h / 2 * dirX, square, h / 2 * dirY, lessAndMore);
    }

    /** Metrics at rotations of h rad/s less and more. */
    void alongRotation(double h, double[] lessAndMore) {
        takePlaces();
        lessAndMore(timeY, -h, timeX, h, lessAndMore);
    }

    /** Metrics at growths of h per s less and more. */
    void alongGrowth(double h, double[] lessAndMore) {
        takeGrowth(fromX, growsFromX, alongX);
        takeGrowth(fromY, growsFromY, alongY);
        lessAndMore(alongX, h, alongY, h, lessAndMore);
    }

    private void takeGrowth(float[] place, double from, ShiftProfile along) {
        for (int i = 0; i < grid.size(); i++) {
            shift[i] = (float) ((place[i] - from) * tau[i]);
        }
        along.take(shift, grid.size());
    }

    /** Metrics at changes of the rotation of h rad/s² less and more. */
    void alongSpin(double h, double[] lessAndMore) {
        takeSquare();
        takePlaces();
        alongX.takeProduct(placeY, square, grid.size());
        alongY.takeProduct(placeX, square, grid.size());
        lessAndMore(alongX, -h / 2, alongY, h / 2, lessAndMore);
    }

    private void lessAndMore(ShiftProfile x, double hx, ShiftProfile y, double hy, double[] metrics) {
        metrics[0] = grid.metric(x, -hx, y, -hy);
        metrics[1] = grid.metric(x, hx, y, hy);
    }

    private void takeSquare() {
        if (!squared) {
            square.takeProduct(time, time, grid.size());
            squared = true;
        }
    }

    private void takePlaces() {
        if (!placed) {
            int size = grid.size();
            placeX.take(fromX, size);
            placeY.take(fromY, size);
            timeX.takeProduct(placeX, time, size);
            timeY.takeProduct(placeY, time, size);
            placed = true;
        }
    }

    /** Metric of the events moved back by a rotation in rad/s and a growth in 1/s about the centre. */
    double atTurn(double omega, double growth) {
        return atTurn(omega, growth, 0, 0);
    }

    /** The same, less a rotation and a growth about the middle of the tile that each event lies on. */
    double atTurn(double omega, double growth, double lessOmega, double lessGrowth) {
        if (!tiled) {
            tiles.find(fromX, fromY, grid.size());
            tiled = true;
        }
        takeTurn(fromX, tiles.middleX(), fromY, tiles.middleY(), growth, growsFromX, -omega, lessGrowth, -lessOmega,
            alongX);
        takeTurn(fromY, tiles.middleY(), fromX, tiles.middleX(), growth, growsFromY, omega, lessGrowth, lessOmega,
            alongY);
        return grid.metric(alongX, 1, alongY, 1);
    }

    private void takeTurn(float[] own, float[] ownMiddle, float[] other, float[] otherMiddle, double growth,
                          double from, double turn, double lessGrowth, double lessTurn, ShiftProfile along) {
        int[] tile = tiles.ofEvents();
        for (int i = 0; i < grid.size(); i++) {
            double ownWithin = own[i] - ownMiddle[tile[i]];
            double otherWithin = other[i] - otherMiddle[tile[i]];
            shift[i] = (float) ((growth * (own[i] - from) + turn * other[i] - lessGrowth * ownWithin
                - lessTurn * otherWithin) * tau[i]);
        }
        along.take(shift, grid.size());
    }
}
