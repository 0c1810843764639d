/**
 * The motion under which events are sharpest, and how well the events determine it. Open
 * {@link io.github.sofas.flow.fit.MetricFit} first.
 *
 * <p>A room of {@code flow}: what is public here is public for the other rooms, and may change with any version.
 */
package io.github.sofas.flow.fit;
