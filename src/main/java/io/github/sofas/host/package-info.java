/**
 * Filters of a jAER on this machine as methods that label events. Open {@link io.github.sofas.host.JaerFilter} first.
 * jAER runs in a process of its own, with the plugin's jar; none of its classes are used here.
 */
package io.github.sofas.host;
