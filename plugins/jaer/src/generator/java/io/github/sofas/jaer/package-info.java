/** What writes sources of the filter at build time. */
package io.github.sofas.jaer;
