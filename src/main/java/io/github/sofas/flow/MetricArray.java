package io.github.sofas.flow;

/**
 * The metrics of the flow plane at one moment (paper, section Flow Plane and its figures), for pictures. Immutable.
 *
 * <p>n x n values. {@code default}: rows are rings from the slowest to the fastest, columns directions from rightwards
 * on towards downwards, every other ring turned by half a column. {@code paper}: columns are angles along x, rows along
 * y, from the most negative to the most positive.
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

    /** {@return rows, and columns} */
    public int n() {
        return n;
    }

    /**
     * {@return the metric per event that the projection holds: about 1 for chance; 0 where it holds none}
     *
     * @param row from 0 to n - 1
     * @param column from 0 to n - 1
     */
    public float perEvent(int row, int column) {
        return perEvent[row * n + column];
    }
}
