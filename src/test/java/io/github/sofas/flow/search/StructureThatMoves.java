package io.github.sofas.flow.search;

import io.github.sofas.flow.motion.Motion;

/**
 * A structure that is tracked, moves right at a speed, and takes nothing, and who tracks it, and is told of nothing:
 * what tests of the search extend.
 */
class StructureThatMoves implements Structures.Structure, Structures {
    private final double speed;

    StructureThatMoves(double speed) {
        this.speed = speed;
    }

    @Override
    public boolean isFull() {
        return false;
    }

    @Override
    public Structure create(long nowUs, double vxPxPerS, double vyPxPerS) {
        return this;
    }

    @Override
    public boolean takes(int x, int y, long timeUs, int polarity) {
        return false;
    }

    @Override
    public void report(Recognition to, long nowUs) {
    }

    @Override
    public void see(int id, int x, int y, long timeUs, int polarity, long nowUs) {
        throw new AssertionError("none is known");
    }

    @Override
    public void addPast(int x, int y, long timeUs, int polarity) {
    }

    @Override
    public void begin(long nowUs) {
    }

    @Override
    public boolean expects(int x, int y, long timeUs, int polarity) {
        return false;
    }

    @Override
    public boolean isTracked() {
        return true;
    }

    @Override
    public double speed() {
        return speed;
    }

    @Override
    public void copyMotion(Motion motion) {
        motion.set(0, speed, 0);
    }

    @Override
    public boolean isAround(int x, int y, double marginPx, long nowUs) {
        return true;
    }

    @Override
    public void see(int x, int y, long timeUs, int polarity, long nowUs) {
    }
}
