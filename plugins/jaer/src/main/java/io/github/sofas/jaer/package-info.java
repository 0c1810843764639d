/**
 * SOFAS as a filter of jAER. Open {@link io.github.sofas.jaer.SofasFlow} first.
 *
 * <p>jAER's own axes are y up, origin lower left; {@link io.github.sofas.jaer.PacketAdapter} turns its events, and
 * {@link io.github.sofas.jaer.SofasFlow} its velocities. Nothing else here knows of both.
 */
package io.github.sofas.jaer;
