/**
 * Published methods that give each event a velocity from its close surroundings, to compare SOFAS with. Open
 * {@link io.github.sofas.baseline.LucasKanade} first; {@link io.github.sofas.baseline.LocalPlanes} has the same shape.
 *
 * <p>Both are written after B. Rueckauer and T. Delbruck, "Evaluation of event-based algorithms for optical flow with
 * ground-truth from inertial measurement sensor", Frontiers in Neuroscience 10:176, 2016, with the defaults of the
 * authors' filters in jAER. They measure the flow across an edge, the normal flow, and find no segments: an event with
 * flow gets segment 1. Their segmentation figures are therefore those of a method that takes the whole scene for one
 * object.
 */
package io.github.sofas.baseline;
