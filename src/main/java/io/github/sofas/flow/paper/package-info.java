/**
 * The method as published (Stoffregen and Kleeman, ACRA 2017), the preset {@code paper}. Open
 * {@link io.github.sofas.flow.paper.FlowPlane}, then {@link io.github.sofas.flow.paper.TrackPlane}.
 *
 * <p>A room of {@code flow}: what is public here is public for the other rooms, and may change with any version.
 */
package io.github.sofas.flow.paper;
