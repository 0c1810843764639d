package io.github.sofas.experiments;

/**
 * A quantity over time.
 *
 * @param timeS time in s
 * @param values the quantity; not a number where there is none
 */
record Curve(double[] timeS, double[] values) {
}
