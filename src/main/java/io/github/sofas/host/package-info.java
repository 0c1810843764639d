/**
 * Filters of a jAER on this machine as methods that label events. Open {@link io.github.sofas.host.JaerFilter} first.
 * jAER runs in a process of its own, with the plugin's jar; nothing of it is seen here.
 */
package io.github.sofas.host;
