/**
 * Accuracy of flow and segments, measured against the truth or by the sharpness of the picture. Start with
 * {@link io.github.sofas.evaluate.Evaluation}, which computes all figures from the truth and the estimate of every
 * event. The formulas are in {@link io.github.sofas.evaluate.FlowFigures},
 * {@link io.github.sofas.evaluate.SegmentationFigures} and {@link io.github.sofas.evaluate.ConvergenceBin}. For
 * recordings without truth, {@link io.github.sofas.evaluate.Sharpness} measures how much sharper the flow makes the
 * picture.
 *
 * <p>The conventions follow jAER's motion flow statistics (Rueckauer and Delbruck, "Evaluation of event-based
 * algorithms for optical flow with ground-truth from inertial measurement sensor", Frontiers in Neuroscience, 2016)
 * where jAER has one: errors over the events that have flow, standard deviations with n - 1, quartiles at the positions
 * p (n + 1), outliers by 3 px at 45 frames per second. Each class documents its own deviations from jAER.
 */
package io.github.sofas.evaluate;
