/**
 * Structures that are tracked. Open {@link io.github.sofas.flow.track.TrackPlaneStack} first, then
 * {@link io.github.sofas.flow.track.TrackPlane}.
 *
 * <p>A room of {@code flow}: what is public here is public for the other rooms, and may change with any version.
 */
package io.github.sofas.flow.track;
