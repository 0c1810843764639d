package io.github.sofas.flow.fit;

/**
 * The metric of a set of events under motions beside the one that they were projected along (paper, section Structure
 * Detection): how they vote in the {@link BilinearAccumulator} when each is shifted by a parameter of the motion times
 * what a unit of it shifts the event by.
 */
final class Metric {
    private static final int EVENT_BYTES = 12 * Integer.BYTES + Byte.BYTES;

    /** Events, projected along the motion. */
    private final BilinearAccumulator grid;
    // of each event: time from the reference in s, and place from the centre of rotation in px
    private final float[] tau;
    private final float[] fromX;
    private final float[] fromY;
    /** Tiles, and whether they are those of these events. */
    private final Tiles tiles;
    private boolean tiled;
    /** Shifts a unit of the parameter that is looked at. */
    private final float[] shift;
    private final ShiftProfile time;
    /** For an acceleration in any direction, and whether it is that of these events. */
    private final ShiftProfile square;
    private boolean squared;
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
        alongX = new ShiftProfile(capacity);
        alongY = new ShiftProfile(capacity);
    }

    /** Bytes of the arrays for up to a number of events. */
    static long bytes(int sensorWidth, int sensorHeight, double cellPx, int capacity) {
        return 2L * Integer.BYTES * BilinearAccumulator.cells(sensorWidth, sensorHeight, cellPx)
            + DenseVotes.BYTES + (long) capacity * EVENT_BYTES;
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
    }

    void add(float x, float y, float tauS, float rx, float ry, int polarity) {
        int i = grid.size();
        grid.add(x, y, polarity);
        tau[i] = tauS;
        fromX[i] = rx;
        fromY[i] = ry;
    }

    /** Lays out the events that were added, before the first metric of them. */
    void lay() {
        grid.lay();
        time.take(tau, grid.size());
        squared = false;
        tiled = false;
    }

    /** Adds up how the picture of the events changes; the structure has so many px of radius. */
    void structure(StructureTensor tensor, double radius) {
        grid.structure(tensor, grid.x(0) - fromX[0], grid.y(0) - fromY[0], radius);
    }

    /** Of the events moved back by velocity (vx, vy) in px/s. */
    double atVelocity(double vx, double vy) {
        return grid.metric(time, vx, time, vy);
    }

    /** At accelerations of h px/s² less and more along (dirX, dirY). */
    void alongAcceleration(double dirX, double dirY, double h, double[] lessAndMore) {
        if (!squared) {
            for (int i = 0; i < grid.size(); i++) {
                shift[i] = 0.5f * tau[i] * tau[i];
            }
            square.take(shift, grid.size());
            squared = true;
        }
        lessAndMore[0] = grid.metric(square, -h * dirX, square, -h * dirY);
        lessAndMore[1] = grid.metric(square, h * dirX, square, h * dirY);
    }

    /** At rotations of h rad/s less and more. */
    void alongRotation(double h, double[] lessAndMore) {
        alongPlace(fromY, -1, fromX, 1, false, h, lessAndMore);
    }

    /** At changes of the rotation of h rad/s² less and more. */
    void alongSpin(double h, double[] lessAndMore) {
        alongPlace(fromY, -1, fromX, 1, true, h, lessAndMore);
    }

    /** At growths of h per s less and more. */
    void alongGrowth(double h, double[] lessAndMore) {
        alongPlace(fromX, 1, fromY, 1, false, h, lessAndMore);
    }

    /** Of shifts by places from the centre times the time, or half its square. */
    private void alongPlace(float[] placeX, float signX, float[] placeY, float signY, boolean isSquare, double h,
                            double[] lessAndMore) {
        takePlace(placeX, signX, isSquare, alongX);
        takePlace(placeY, signY, isSquare, alongY);
        lessAndMore[0] = grid.metric(alongX, -h, alongY, -h);
        lessAndMore[1] = grid.metric(alongX, h, alongY, h);
    }

    private void takePlace(float[] place, float sign, boolean isSquare, ShiftProfile along) {
        for (int i = 0; i < grid.size(); i++) {
            shift[i] = sign * place[i] * tau[i] * (isSquare ? 0.5f * tau[i] : 1);
        }
        along.take(shift, grid.size());
    }

    /** Of the events moved back by a rotation in rad/s and a growth in 1/s about the centre. */
    double atTurn(double omega, double growth) {
        return atTurn(omega, growth, 0, 0);
    }

    /** The same, less a rotation and a growth about the middle of the tile that each event lies on. */
    double atTurn(double omega, double growth, double lessOmega, double lessGrowth) {
        if (!tiled) {
            tiles.find(fromX, fromY, grid.size());
            tiled = true;
        }
        takeTurn(fromX, tiles.middleX(), fromY, tiles.middleY(), growth, -omega, lessGrowth, -lessOmega, alongX);
        takeTurn(fromY, tiles.middleY(), fromX, tiles.middleX(), growth, omega, lessGrowth, lessOmega, alongY);
        return grid.metric(alongX, 1, alongY, 1);
    }

    private void takeTurn(float[] own, float[] ownMiddle, float[] other, float[] otherMiddle, double growth,
                          double turn, double lessGrowth, double lessTurn, ShiftProfile along) {
        int[] tile = tiles.ofEvents();
        for (int i = 0; i < grid.size(); i++) {
            double ownWithin = own[i] - ownMiddle[tile[i]];
            double otherWithin = other[i] - otherMiddle[tile[i]];
            shift[i] = (float) ((growth * own[i] + turn * other[i] - lessGrowth * ownWithin - lessTurn * otherWithin)
                * tau[i]);
        }
        along.take(shift, grid.size());
    }
}
