package io.github.sofas.flow.paper;

import io.github.sofas.flow.PlainPlane.Cell;
import io.github.sofas.flow.PlainPlane.Event;
import io.github.sofas.flow.PlainPlane.Plane;
import io.github.sofas.flow.PlainPlane;
import io.github.sofas.flow.Segment;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * The paper's track plane, as plain as can be: the cells of all projections are found anew at every event.
 * {@link TrackPlane} must agree with it exactly.
 */
final class PlainTrackPlane {
    private final Numbers p;
    final int id;
    final long firstUs;
    List<Event> live;
    private final Map<Cell, Integer> raised = new HashMap<>();
    final int[] hits = new int[9];
    double angleX;
    double angleY;
    double h;
    private long newestUs;
    private long referenceUs;
    private long lifetimeUs;
    private long checkedUs;
    private int sinceCheck;
    long events;
    long lastUs;
    double vxPxPerS;
    double vyPxPerS;
    int minX;
    int minY;
    int maxX;
    int maxY;
    int recentrings;

    PlainTrackPlane(Numbers p, int id, List<Event> structure, double angleX, double angleY) {
        this.p = p;
        this.id = id;
        live = new ArrayList<>(structure);
        newestUs = live.get(live.size() - 1).timeUs();
        firstUs = newestUs;
        lastUs = newestUs;
        checkedUs = newestUs;
        double spacing = p.rangeDeg() / Math.pow(p.refinement(), p.cycles() - 1) / p.flowProjections();
        h = Math.min(p.maxPerturbationDeg(), Math.max(p.minPerturbationDeg(), spacing));
        centre(angleX, angleY);
    }

    /** Projection k, row by row: 0 is left above the centre, 4 the centre. */
    private Plane projection(int k) {
        double ax = PlainPlane.limited(angleX + (k % 3 - 1) * h);
        double ay = PlainPlane.limited(angleY + (k / 3 - 1) * h);
        double scale = p.velocityScalePxPerS();
        return new Plane(PlainPlane.velocity(scale, ax), PlainPlane.velocity(scale, ay), referenceUs);
    }

    private Set<Cell> occupied(int k) {
        Plane plane = projection(k);
        Set<Cell> cells = new HashSet<>();
        for (Event e : live) {
            cells.add(plane.cellOf(e));
        }
        return cells;
    }

    int cells(int i, int j) {
        return occupied(j * 3 + i).size();
    }

    boolean offer(Event e) {
        expire(e.timeUs());
        for (int k = 0; k < 9; k++) {
            if (occupied(k).contains(projection(k).cellOf(e))) {
                hits[k]++;
            }
        }
        Cell cell = projection(4).cellOf(e);
        boolean belongs = occupied(4).contains(cell)
            || raised.merge(cell, 1, Integer::sum) > p.contourThreshold();
        if (belongs) {
            live.add(e);
            newestUs = e.timeUs();
            lastUs = e.timeUs();
            events++;
            sinceCheck++;
        }
        recentreWhereSomeoneIsBest();
        return belongs;
    }

    private void recentreWhereSomeoneIsBest() {
        if (live.isEmpty()) {
            return;
        }
        int[] cells = new int[9];
        List<Integer> passing = new ArrayList<>();
        for (int k = 0; k < 9; k++) {
            cells[k] = occupied(k).size();
            if (hits[k] > p.hitShare() * cells[k]) {
                passing.add(k);
            }
        }
        if (passing.isEmpty()) {
            return;
        }
        Comparator<Integer> byShare =
            (a, b) -> Long.compare((long) hits[a] * cells[b], (long) hits[b] * cells[a]);
        int best = passing.stream().max(byShare).get();
        double x = 0;
        double y = 0;
        int equals = 0;
        for (int k = 0; k < 9; k++) {
            if (byShare.compare(k, best) == 0) {
                x += k % 3 - 1;
                y += k / 3 - 1;
                equals++;
            }
        }
        boolean stays = byShare.compare(4, best) == 0;
        double stepX = stays ? 0 : x / equals;
        double stepY = stays ? 0 : y / equals;
        double newX = angleX + stepX * h;
        double newY = angleY + stepY * h;
        h = stepX == 0 && stepY == 0 ? Math.max(p.minPerturbationDeg(), h / 2)
            : Math.min(p.maxPerturbationDeg(), h * 2);
        recentrings++;
        centre(newX, newY);
    }

    private void centre(double newX, double newY) {
        angleX = PlainPlane.limited(newX);
        angleY = PlainPlane.limited(newY);
        vxPxPerS = PlainPlane.velocity(p.velocityScalePxPerS(), angleX);
        vyPxPerS = PlainPlane.velocity(p.velocityScalePxPerS(), angleY);
        double speed = Math.max(Math.hypot(vxPxPerS, vyPxPerS), 1e-6);
        lifetimeUs = (long) Math.min(p.maxLifetimeUs(), p.lifetimePx() / speed * 1e6);
        referenceUs = newestUs;
        expire(newestUs);
        raised.clear();
        Arrays.fill(hits, 0);
        minX = live.stream().mapToInt(Event::x).min().getAsInt();
        minY = live.stream().mapToInt(Event::y).min().getAsInt();
        maxX = live.stream().mapToInt(Event::x).max().getAsInt();
        maxY = live.stream().mapToInt(Event::y).max().getAsInt();
    }

    private void expire(long nowUs) {
        live.removeIf(e -> e.timeUs() < nowUs - lifetimeUs);
    }

    boolean isStarved(long nowUs) {
        expire(nowUs);
        if (live.isEmpty()) {
            return true;
        }
        if (nowUs - checkedUs < lifetimeUs) {
            return false;
        }
        boolean starved = sinceCheck < p.minShare() * cells(1, 1);
        checkedUs = nowUs;
        sinceCheck = 0;
        return starved;
    }

    boolean describesSameAs(PlainTrackPlane other) {
        // velocities as they are reported
        float dvx = (float) vxPxPerS - (float) other.vxPxPerS;
        float dvy = (float) vyPxPerS - (float) other.vyPxPerS;
        double speed = Math.max(Math.hypot((float) vxPxPerS, (float) vyPxPerS),
            Math.hypot((float) other.vxPxPerS, (float) other.vyPxPerS));
        return Math.hypot(dvx, dvy) <= p.mergeVelocity() * speed
            && minX <= other.maxX + 1 && other.minX <= maxX + 1 && minY <= other.maxY + 1 && other.minY <= maxY + 1;
    }

    void merge(PlainTrackPlane other) {
        List<Event> both = new ArrayList<>(live);
        both.addAll(other.live);
        both.sort(Comparator.comparingLong(Event::timeUs));
        live = both;
        events += other.events;
        sinceCheck += other.sinceCheck;
        lastUs = Math.max(lastUs, other.lastUs);
        if (!live.isEmpty()) {
            newestUs = live.get(live.size() - 1).timeUs();
            centre(angleX, angleY);
        }
    }

    Segment segment(Segment.Fate fate, int mergedInto) {
        return new Segment(id, firstUs, lastUs, events, (float) vxPxPerS, (float) vyPxPerS, 0, 0, minX, minY, maxX,
            maxY, fate, mergedInto);
    }
}
