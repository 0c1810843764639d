/**
 * Where events were and will be: the projection of an event, and the motion of a structure. Start with
 * {@link io.github.sofas.flow.motion.Projection}.
 *
 * <p>A room of {@code flow}: what is public here is public for the other rooms, and may change with any version.
 */
package io.github.sofas.flow.motion;
