/**
 * Events and their sources. Start with {@link io.github.sofas.event.EventBatch}, which carries events between readers,
 * engine and writers. This package depends on no other.
 */
package io.github.sofas.event;
