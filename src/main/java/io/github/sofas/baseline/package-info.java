/**
 * Published methods to compare SOFAS with, which give each event a velocity from its close surroundings. Start with
 * {@link io.github.sofas.baseline.LucasKanade}; {@link io.github.sofas.baseline.LocalPlanes} has the same structure.
 *
 * <p>Both methods follow B. Rueckauer and T. Delbruck, "Evaluation of event-based algorithms for optical flow with
 * ground-truth from inertial measurement sensor", Frontiers in Neuroscience 10:176, 2016, with the defaults of the
 * authors' filters in jAER. They measure the flow across an edge, the normal flow. They find no segments: every event
 * with flow gets segment 1. Their segmentation figures are therefore those of a method that takes the whole scene for
 * one object.
 *
 * <p>The table compares these methods with the filters of jAER 3.3, on shapes at 58 px/s with 0.1 Hz/px of noise. It
 * has the mean magnitude error and the mean relative endpoint error of the events with flow. Our methods see the scenes
 * of this program (blur 0.7 px, contrast 0.7); jAER's filters saw similar scenes of another simulator.
 * <table>
 * <caption>Magnitude error, relative endpoint error</caption>
 * <tr><th></th><th>hexagon</th><th>large circle</th><th>small circle</th><th>rectangles</th></tr>
 * <tr><td>Lucas-Kanade, central differences</td><td>-82, 97 %</td><td>-80, 100 %</td><td>-78, 100 %</td>
 *     <td>-79, 101 %</td></tr>
 * <tr><td>jAER's</td><td>-73, 99 %</td><td>-60, 108 %</td><td>-74, 100 %</td><td>-57, 110 %</td></tr>
 * <tr><td>Lucas-Kanade, Savitzky-Golay</td><td>-21, 62 %</td><td>-22, 71 %</td><td>-30, 80 %</td>
 *     <td>-30, 62 %</td></tr>
 * <tr><td>jAER's</td><td>-17, 70 %</td><td>-12, 86 %</td><td>-36, 81 %</td><td>-34, 66 %</td></tr>
 * <tr><td>local planes</td><td>-4, 51 %</td><td>0, 54 %</td><td>+18, 38 %</td><td>+8, 12 %</td></tr>
 * <tr><td>jAER's</td><td>-12, 48 %</td><td>-16, 56 %</td><td>-1, 25 %</td><td>+1, 4 %</td></tr>
 * </table>
 * With a blur of 0.3 px and a contrast of 1.0, local planes give -11, 50 % for the hexagon, -16, 48 % for the large
 * circle and +1, 4 % for the rectangles, with flow for 22 to 24 % of the events, in line with jAER's
 * filter. The first events of a sharp edge lie in a plane, but those of a blurred edge scatter.
 */
package io.github.sofas.baseline;
