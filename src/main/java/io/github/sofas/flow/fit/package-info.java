/**
 * Fits of motion: the motion under which a set of events is sharpest, and how well the events determine that motion.
 * Start reading with {@link io.github.sofas.flow.fit.MetricFit}.
 *
 * <p>This package is a room of {@code flow}: its public types are public for the other rooms, and may change with any
 * version.
 */
package io.github.sofas.flow.fit;
