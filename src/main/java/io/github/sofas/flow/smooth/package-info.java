/**
 * Labels that know what comes next. Open {@link io.github.sofas.flow.smooth.Smoother} first.
 *
 * <pre>
 *   labelled event ──> window, cut into slices of a quarter of the look-ahead
 *   measured motion ─> path of its segment: a knot at the middle of the window that it was measured over
 *                         │
 *                         v
 *   slice ── after two more: paths that turn measured anew, those that bend aligned
 *         ── then: competition of the paths for its open events; after four: again, for good
 *         ── velocity of each event from the path of its segment
 * </pre>
 *
 * <p>Ours beyond the paper, which labels events as they come. A recording has a future, and a velocity that lags by
 * half a window, an event of before its structure was found, or one between two, need not stay as they were.
 */
package io.github.sofas.flow.smooth;
