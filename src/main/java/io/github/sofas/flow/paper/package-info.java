/**
 * The method as published (Stoffregen and Kleeman, ACRA 2017), which is the preset {@code paper}. Start with
 * {@link io.github.sofas.flow.paper.FlowPlane}, then read {@link io.github.sofas.flow.paper.TrackPlane}.
 *
 * <p>A room of {@code flow}: what is public here is public for the other rooms, and may change with any version.
 */
package io.github.sofas.flow.paper;
