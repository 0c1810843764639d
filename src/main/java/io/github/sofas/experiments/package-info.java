/**
 * Runs the paper's experiments on simulated scenes whose truth is known, and on real recordings if there are any: both
 * presets of SOFAS beside Lucas-Kanade and local planes. Open {@link io.github.sofas.experiments.Experiments} first: it
 * runs all experiments. {@link io.github.sofas.experiments.ExperimentFiles} writes the page and the CSV files. The
 * scenes and the goals are in {@code Setting}.
 */
package io.github.sofas.experiments;
