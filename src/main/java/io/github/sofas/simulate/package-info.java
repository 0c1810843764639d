/**
 * Simulates moving shapes seen by a threshold model of an event camera, with the truth of every event. Open
 * {@link io.github.sofas.simulate.Scene} first: it lists the scenes.
 * {@link io.github.sofas.simulate.SimulatedSource} films a scene, and
 * {@link io.github.sofas.simulate.SimulatedRecording} keeps a whole film in memory.
 *
 * <p>From scene to event: a scene is composed into a {@link io.github.sofas.simulate.World} of rigid objects, front to
 * back, each a {@link io.github.sofas.simulate.Shape} on a {@link io.github.sofas.simulate.Trajectory}. The
 * {@link io.github.sofas.simulate.Renderer} computes the light of the pixels near moving edges, in time steps within
 * which nothing moves by more than a quarter pixel. {@link io.github.sofas.simulate.PixelArray} turns the logarithm of
 * that light into events, with times interpolated between the steps. The source asks the renderer which object caused
 * an event, adds noise and puts all events in order of time.
 *
 * <p>The centre of pixel (x, y) is the point (x, y) of the plane. Angles are in degrees or radians, as their names say,
 * and turn from right to down, clockwise as seen. The same options give the same events on every machine: only
 * {@link java.lang.StrictMath} and {@link java.util.Random} are used.
 */
package io.github.sofas.simulate;
