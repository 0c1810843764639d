/**
 * Runs the motion-flow filters of a jAER installation on this machine as methods that label events, for comparison.
 * Open {@link io.github.sofas.host.JaerFilter} first. jAER runs in a process of its own, with the plugin's jar; this
 * package uses none of jAER's classes.
 */
package io.github.sofas.host;
