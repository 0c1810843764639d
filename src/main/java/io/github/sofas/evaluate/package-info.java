/**
 * Accuracy of flow and segments, compared with the truth or by the sharpness of the picture. Open
 * {@link io.github.sofas.evaluate.Evaluation} first: it takes the truth and the estimate of every event and gives all
 * figures. The formulas are in {@link io.github.sofas.evaluate.FlowFigures},
 * {@link io.github.sofas.evaluate.SegmentationFigures} and {@link io.github.sofas.evaluate.ConvergenceBin}. Without
 * truth, {@link io.github.sofas.evaluate.Sharpness} measures how much sharper the flow makes the picture.
 *
 * <p>Conventions are those of jAER's motion flow statistics (Rueckauer and Delbruck, "Evaluation of event-based
 * algorithms for optical flow with ground-truth from inertial measurement sensor", Frontiers in Neuroscience, 2016)
 * where it has any: errors over the events that have flow, standard deviations with n - 1, quartiles at the positions
 * p (n + 1), outliers by 3 px at 45 frames per second. Each deviation is named where it is made.
 */
package io.github.sofas.evaluate;
