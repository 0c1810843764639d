package io.github.sofas.flow;

/**
 * The metrics of the flow plane at one moment (paper, section Flow Plane and its figures), for pictures. Immutable.
 *
 * <p>It has n x n values. {@code default}: rows are rings of speed, from the slowest to the fastest; columns are
 * directions, from rightwards on towards downwards, and every other ring is turned by half a column. {@code paper}:
 * columns are angles along x and rows angles along y, from the most negative to the most positive.
 */
public final class MetricArray {
    private final SofasParameters.Preset preset;
    private final int n;
    private final float[] perEvent;

    MetricArray(SofasParameters.Preset preset, int n, float[] perEvent) {
        this.preset = preset;
        this.n = n;
        this.perEvent = perEvent;
    }

    /** {@return how rows and columns are laid out} */
    public SofasParameters.Preset preset() {
        return preset;
    }

    /** {@return the number of rows, which is also the number of columns} */
    public int n() {
        return n;
    }

    /**
     * {@return the metric per event that the projection holds: about 1 for chance; 0 if it holds no events}
     *
     * @param row from 0 to n - 1
     * @param column from 0 to n - 1
     */
    public float perEvent(int row, int column) {
        return perEvent[row * n + column];
    }
}
