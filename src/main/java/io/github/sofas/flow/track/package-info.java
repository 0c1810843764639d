/**
 * Tracking of the structures that were found. Start with {@link io.github.sofas.flow.track.TrackPlaneStack}, then read
 * {@link io.github.sofas.flow.track.TrackPlane}.
 *
 * <p>A room of {@code flow}: what is public here is public for the other rooms, and may change with any version.
 */
package io.github.sofas.flow.track;
