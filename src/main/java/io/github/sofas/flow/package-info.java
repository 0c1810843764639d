/**
 * The method: simultaneous optical flow and segmentation (Stoffregen and Kleeman, ACRA 2017). Open
 * {@link io.github.sofas.flow.Sofas} first. Depends on {@code event} only.
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
 * structures), {@code flow.track} (structures that are tracked), {@code flow.paper} (the published method). The rooms
 * are no part of the API: they may change with any version, and nothing outside of {@code flow} uses them.
 *
 * <p><b>Terms.</b> An event is projected along a velocity to where it would have been at a reference time
 * ({@link io.github.sofas.flow.motion.Projection}). An accumulator sums the events, ON +1 and OFF -1, on each cell of a
 * projection; the metric is the sum of its squares. Under the true velocity the events of an edge fall on each other,
 * and the metric is greatest. Adding w to a cell raises it by 2 w f + w², so that it is kept event by event.
 *
 * <p><b>Two methods</b> stand side by side. {@code flow.paper} is the method as published, the preset {@code paper}:
 * flow plane, refinement, track planes with hits, a stack asked in turn. The others are the preset {@code default}:
 * the same nouns, with these differences, each a parameter of {@link io.github.sofas.flow.SofasParameters} or told
 * where it is.
 *
 * <ul>
 * <li><b>Lifespan by travel.</b> Each projection of the flow plane holds the events of the time in which its own
 *     velocity travels six pixels. One lifespan for all is too long for the fast and too short for the slow: the
 *     paper's hexagon at 5.8 px/s is found after 93 px of travel or never, ours after 4 px at any speed from 5.8 to
 *     289 px/s.
 * <li><b>Evidence.</b> Sliding a straight edge along itself is rewarded while counts are small. A piece becomes a
 *     track plane when its travel across itself and its density suffice, and of velocities about as good the
 *     slowest is taken. Without this, rectangles were tracked at 72 px/s in eight pieces instead of at 58 px/s in
 *     one.
 * <li><b>Meetings, not events.</b> Votes are bilinear, and the metric leaves out what an event adds by itself: that
 *     part favours whole pixels. It made a dither needless whose noise was larger than all others' (small circle's
 *     direction: 0.3 degrees with it, 0.1 without).
 * <li><b>A frame of knowledge.</b> The 3 x 3 projections are turned and spaced so that each neighbour loses 4 % of
 *     the metric, and the step to the top of a quadratic through them counts as far as it is known. An edge moves
 *     sharply across and slowly along itself: direction of the rectangles 0 ± 5 degrees before, ± 1.2 after.
 * <li><b>Long windows, velocity of now.</b> Lifetimes grow from 5 to 16 px while the motion is steady. Acceleration
 *     and rotation are measured by projections of their own, believed where they pass the noise, and carry the
 *     velocity from the middle of the window to now: a pendulum's velocity lagged by 25 px/s of 380, and no longer
 *     does.
 * <li><b>The likeliest plane.</b> An event goes to the plane that predicts it at the greatest rate, not to the
 *     first of the stack; events that two planes claim measure neither. Four bars overtaking each other:
 *     intersection over union 0.49 before, 0.87 after.
 * <li><b>A memory of the shape.</b> A track plane remembers where its contour was for 64 px of travel, and takes an
 *     event there that lies on no contour, without measuring it; a structure that is hidden is waited for. Edges that
 *     come out from behind others would else be structures of their own: three movers that cross, intersection over
 *     union 0.85 before, 0.93 after; a circle hidden behind a rectangle 0.92 and 0.97, and it keeps its id.
 * <li><b>Front and back.</b> A dark and a bright edge of one velocity may merge over twice their length. With the
 *     memory, three wanderers: 0.50 before, 0.74 after.
 * <li><b>Two grids.</b> Up to 1,900 events vote on two grids half a cell apart: on one, a thin edge in the middle of a
 *     cell has a greater metric than between two, at its true velocity too. The synthetic square (24 px, no noise)
 *     swung by 2 px/s, now by up to 1; a regular edge of an event per pixel ran away to five times its speed.
 * <li><b>A quarter of the live events</b> at least is measured: the direction of four rectangles, known from the ends
 *     of their edges only, had an sd of 1.7 degrees with 2,000 of 14,000. With the acceleration along edges, of which
 *     nothing is known, left out of what shortens the lifetime, it has 0.4.
 * <li><b>Stretches of time.</b> The quarter that is measured is four stretches of the window, from its beginning to its
 *     end, not events here and there: within a stretch all meet, and between two much time has passed. Relative
 *     endpoint error of hexagon and large circle 0.7 % before, 0.25 % after with a third, 0.35 % with a quarter, of
 *     four rectangles 1.1, 0.5 and 0.6 %, of a circle hidden by a rectangle 3.3 and 2.0 %. Boxes before a panned
 *     camera came out 1 px/s of 27 too fast, as events less than a tenth of the window apart make them seem, maybe
 *     because real pixels rest: half of that now. Three stretches leave a pendulum's acceleration less sure (its error
 *     4.7 to 5.6 %), six are less right where motion is steady (0.31 %). Cutting the window in two halves and counting
 *     only meetings between them is faster and as free of that bias, but four bars lost a tenth of their accuracy: the
 *     half in which one is hidden then shows nothing.
 * <li><b>A look in parts.</b> Each event that is labelled earns 120 votes, for the measurements of the track planes
 *     and, with what these leave, for the search, which stops where they are spent, to go on later: no event waits for
 *     a whole look, of up to 9 ms. With 150 for the search alone, the slowest 1 in 100 of a thousand events, one each
 *     ms, took 1.6 to 3.3 ms, now 1.1 to 1.7 (sixteen objects 13 and 9 ms). A new track plane gets what came while its
 *     piece was refined.
 * <li><b>Coarse to look, fine to measure.</b> The flow plane has 9 x 9 projections, as the paper's: 12 x 12 found
 *     nothing earlier, and labelled noise alone at 1.3 instead of 2.2 million events per second. A piece is fitted with
 *     a thousand of its events, and given up at once where it is sharper at rest than along its projection, which
 *     spares half of the votes that were given in vain. Small circles, hexagons and rectangles at 10 to 480 px/s are
 *     found after 5.8, 4.5 and 5.1 px in the mean, and 7.8 px at worst; before, after 6.3, 5.0 and 5.5, and 11.2 px.
 * <li><b>Merging by metric.</b> Two planes are one structure when a common velocity, or a common rigid motion, costs
 *     neither more than 2 % of its metric: a straight edge knows only a part of its velocity, and agrees with any that
 *     has that part; the two ends of a body that turns have two velocities, and one motion. A short rotating bar: 3.6
 *     segments and a relative endpoint error of 36 % before, one segment and 4 % after.
 * <li><b>Held while it is hidden.</b> Where boxes of structures overlap and a sixth of a structure's events is missing,
 *     its motion is held: what is left is pulled along by what hides it. Four bars: 0.86 before, 0.91 after.
 *     Hidden is what has fewer events inside the others' boxes than elsewhere, 0.8 of them. What slows down has fewer
 *     everywhere for the speed it is thought to have: of 16 runs over two rows of stripes, each without another
 *     hundredth of the events, six held the speed for good.
 * <li><b>Turning with the path.</b> What follows a bend turns with it. Of a body whose own rotation does not show, a
 *     disc's, the rotation is that of its path: the bob of a pendulum 5.1 % of its peak speed before, 2.3 % after.
 * <li><b>Known again.</b> A new structure that lies on the remembered contour of a lost one, were that farther back, is
 *     that one again. Three wanderers that turn round: 0.74 before, 0.84 after.
 * <li><b>Place before velocity.</b> What gets few events for its speed slows down, or stands, or turns round, and has
 *     left its contour before any velocity shows that. A dozen events show its place: until it has gone 4 px one way,
 *     its contour is laid on them, whatever their polarity. Three wanderers, twenty seeds: 0.83 before, 0.90 after;
 *     of the events at 20 to 30 px/s 42 % had no flow before, 13 % after. Not while another is beside it, which may
 *     hide it.
 * <li><b>Two bodies that touch.</b> Two that were long tracked apart, and are not the dark and the bright edge of one,
 *     merge after 8 px together only: bodies that meet go the same way for a moment. Three wanderers: 0.90 before, 0.91
 *     after, the mean of twenty seeds; the worst three of those 0.83, 0.85 and 0.87 before, 0.92 to 0.95 after.
 * </ul>
 *
 * <p>What was tried and dropped: a sub-pixel dither (see above), votes without sign (slow planes then collect whatever
 * passes), choosing among planes by support alone or by support relative to their mean (the slower one takes the
 * faster's events), projecting the contour anew only when it is stale (faster, but small structures fell apart), cells
 * of one pixel (favour whole pixels of travel) and of 1.6 (no gain over 1.3), measuring velocity from remembered
 * events too (noise on the contour pulls it: a circle hidden by a rectangle 0.97 to 0.95), remembering them in turn
 * (noise spreads; four bars 0.90 to 0.86), counting what another remembers as claimed by both (bars 0.86 to 0.78),
 * nearest cells on four or sixteen grids instead of bilinear votes (a hexagon moving along an axis is three times as
 * right, one at 20 degrees worse: exact coincidence favours whole pixels), a random place within a cell for each vote
 * (the direction's sd grows by half), every other event on the other grid (too few meet), a structure that gets few
 * events taken to have stopped where it was (wanderers 0.82 to 0.75), events before a turn counted with the other sign,
 * as an edge that comes back shows it (pendulum 1 px/s better, wanderers no better), remembered events of what has
 * just come back measured too (0.79 to 0.77), the rotation of a path taken from measured accelerations (noisier
 * than from the directions of the velocity: large circle's sd 0.4 to 1.1 %), and following by place what slips off its
 * contour, too, though it gets its events (wanderers no better), the slopes of the metric in all parameters at once,
 * from the places of the events, instead of projections beside the motion (half of the votes, but the direction's sd
 * grows by half for a hexagon and from 0.7 to 17 degrees for rectangles: what a few corners tell is seen from afar
 * only), and votes for one cell that are read from four (no faster, twice the sd).
 */
package io.github.sofas.flow;
