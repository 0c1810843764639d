package io.github.sofas.experiments;

/**
 * A quantity over time, as a line of a plot.
 *
 * @param timeS times in s
 * @param values the quantity at these times; NaN where there is no value
 */
record Curve(double[] timeS, double[] values) {
}
