/**
 * SOFAS as a filter of jAER. Open {@link io.github.sofas.jaer.SofasFlow} first.
 *
 * <p>jAER's own axes are y up, origin lower left. {@link io.github.sofas.jaer.PacketAdapter} converts its events, and
 * {@link io.github.sofas.jaer.SofasFlow} its velocities. Drawing and {@link io.github.sofas.jaer.ServeFilter} convert
 * for themselves.
 */
package io.github.sofas.jaer;
