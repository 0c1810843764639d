/**
 * The method: simultaneous optical flow and segmentation (Stoffregen and Kleeman, ACRA 2017). Open
 * {@link io.github.sofas.flow.Sofas} first. {@link io.github.sofas.flow.SmoothedSofas} labels recordings, whose events
 * need not be labelled at once. This package depends on {@code event} only.
 *
 * <pre>
 *   event ──> track plane stack ── on a contour ──> its track plane: velocity and segment of the event
 *                    │                                   │  live events, contour, motion
 *                    │ on none                           └─ every few hundred events: measure the motion
 *                    v
 *               flow plane ── a structure stands out ──> a new track plane, with its events
 *               n x n projections, accumulators, metrics
 * </pre>
 *
 * <p><b>Rooms.</b> This package holds the classes that callers use, and the two methods that wire the rooms. The rooms
 * are {@code flow.motion} (how things move), {@code flow.fit} (the motion along which events are sharpest),
 * {@code flow.search} (new structures), {@code flow.track} (structures that are tracked), {@code flow.smooth} (labels
 * that take later events into account) and {@code flow.paper} (the published method). The rooms are not part of the
 * API: they may change with any version, and nothing outside {@code flow} uses them.
 *
 * <p><b>Terms.</b> An event is projected along a velocity to where it would have been at a reference time
 * ({@link io.github.sofas.flow.motion.Projection}). An accumulator sums the events, ON +1 and OFF -1, on each cell of a
 * projection; the metric is the sum of its squares. Along the true velocity the events of an edge fall on each other,
 * and the metric is greatest. Adding w to a cell with sum f raises the metric by 2 w f + w², so that it is updated
 * event by event.
 *
 * <p><b>Two methods</b> stand side by side. {@code flow.paper} is the method as published, the preset {@code paper}.
 * The other rooms are the preset {@code default}: the same nouns, made accurate and fast. {@code docs/method.md} lists
 * what the default preset does differently and why; {@code docs/decisions.md} lists what was tried, with figures.
 */
package io.github.sofas.flow;
