/**
 * The method. Open {@link io.github.sofas.flow.Sofas} first. Depends on {@code event} only.
 */
package io.github.sofas.flow;
