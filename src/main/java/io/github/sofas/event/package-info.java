/**
 * Events and where they come from. Open {@link io.github.sofas.event.EventBatch} first: it is what flows between
 * readers, engine and writers. Depends on nothing.
 */
package io.github.sofas.event;
