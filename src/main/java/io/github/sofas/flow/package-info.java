/**
 * The method: simultaneous optical flow and segmentation (Stoffregen and Kleeman, ACRA 2017). Open
 * {@link io.github.sofas.flow.Sofas} first; {@link io.github.sofas.flow.SmoothedSofas} labels recordings, whose events
 * need not be labelled at once. Depends on {@code event} only.
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
 * <p><b>Rooms.</b> This package holds what callers use, and the two methods that wire the rooms: {@code flow.motion}
 * (how things move), {@code flow.fit} (the motion under which events are sharpest), {@code flow.search} (new
 * structures), {@code flow.track} (structures that are tracked), {@code flow.smooth} (labels that know what comes after
 * an event), {@code flow.paper} (the published method). The rooms are no part of the API: they may change with any
 * version, and nothing outside of {@code flow} uses them.
 *
 * <p><b>Terms.</b> An event is projected along a velocity to where it would have been at a reference time
 * ({@link io.github.sofas.flow.motion.Projection}). An accumulator sums the events, ON +1 and OFF -1, on each cell of a
 * projection; the metric is the sum of its squares. Under the true velocity the events of an edge fall on each other,
 * and the metric is greatest. Adding w to a cell raises it by 2 w f + w², so that it is kept event by event.
 *
 * <p><b>Two methods</b> stand side by side: {@code flow.paper} is the method as published, the preset {@code paper};
 * the other rooms are the preset {@code default}, the same nouns made accurate and fast. What it does differently and
 * why is one page, {@code docs/method.md}; what was tried, with figures, another, {@code docs/decisions.md}.
 */
package io.github.sofas.flow;
