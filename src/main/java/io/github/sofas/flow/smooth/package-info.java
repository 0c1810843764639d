/**
 * Labels that take later events into account. Open {@link io.github.sofas.flow.smooth.Smoother} first.
 *
 * <pre>
 *   labelled event ──> window, cut into slices of a quarter of the look-ahead
 *   measured motion ─> path of its segment: a knot at the middle of the window that it was measured over
 *                         │
 *                         v
 *   slice ── two slices after it: paths that turn are measured anew, paths that bend are aligned,
 *            and the paths compete for its open events
 *         ── four slices after it: they compete again, for good
 *         ── each event gets its velocity from the path of its segment
 * </pre>
 *
 * <p>Ours, because the paper labels events as they come. A recording has a future. With it, labels can be corrected: a
 * velocity that lags by half a window, an event older than the detection of its structure, an event between two
 * structures.
 */
package io.github.sofas.flow.smooth;
