package io.github.sofas.flow.paper;

import io.github.sofas.flow.PlainPlane.Cell;
import io.github.sofas.flow.PlainPlane.Event;
import io.github.sofas.flow.PlainPlane.Plane;
import io.github.sofas.flow.PlainPlane;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * The paper's flow plane with its refining cycles, as plain as can be: everything is projected anew at every event.
 * {@link FlowPlane} and {@link Refinement} must agree with it exactly.
 */
final class PlainFlowPlane {
    private final Numbers p;
    private final int n;
    private final long[] metrics;

    List<Event> events = new ArrayList<>();
    private long referenceUs;
    /** Row-major index of the greatest projection. */
    int best = -1;
    private int constantFor;

    /** The events of the structure found last, and its projection. */
    List<Event> members = new ArrayList<>();
    double angleX;
    double angleY;

    PlainFlowPlane(Numbers p) {
        this.p = p;
        n = p.flowProjections();
        metrics = new long[n * n];
    }

    boolean add(Event e) {
        if (events.isEmpty()) {
            referenceUs = e.timeUs();
        }
        events.removeIf(old -> old.timeUs() < e.timeUs() - p.lifespanUs());
        events.add(e);
        int greatest = greatest();
        constantFor = greatest == best ? constantFor + 1 : 1;
        best = greatest;
        if (constantFor < p.constantEvents()) {
            return false;
        }
        constantFor = 0;
        refine();
        return members.size() >= p.minEvents();
    }

    void release() {
        // two events may be equal: members are the same objects
        events.removeIf(e -> members.stream().anyMatch(m -> m == e));
        if (!events.isEmpty()) {
            referenceUs = events.get(0).timeUs();
        }
        best = -1;
    }

    /** The projection, with the angle as given to the fast one at its construction. */
    private Plane projection(int i, int j) {
        return plane(PlainPlane.angle(0, i, n, p.rangeDeg()), PlainPlane.angle(0, j, n, p.rangeDeg()), referenceUs);
    }

    private Plane plane(double ax, double ay, long reference) {
        double scale = p.velocityScalePxPerS();
        return new Plane(PlainPlane.velocity(scale, ax), PlainPlane.velocity(scale, ay), reference);
    }

    /** The metric of a projection at the last event. */
    long metric(int i, int j) {
        return metrics[i + n * j];
    }

    /** The greatest metric; of equal ones the slowest, of equally slow ones the first. */
    private int greatest() {
        int found = -1;
        long most = -1;
        double slowest = 0;
        for (int k = 0; k < n * n; k++) {
            Plane plane = projection(k % n, k / n);
            long metric = PlainPlane.metric(events, plane);
            metrics[k] = metric;
            double speed = Math.hypot(plane.vxPxPerS(), plane.vyPxPerS());
            if (metric > most || metric == most && speed < slowest * (1 - 1e-9)) {
                found = k;
                most = metric;
                slowest = speed;
            }
        }
        return found;
    }

    private void refine() {
        // in the refining cycles the plane shows the sensor as it was at the oldest event
        long reference = events.get(0).timeUs();
        double range = p.rangeDeg();
        angleX = PlainPlane.angle(0, best % n, n, range);
        angleY = PlainPlane.angle(0, best / n, n, range);
        members = associated(events, plane(angleX, angleY, reference));
        for (int cycle = 1; cycle < p.cycles() && !members.isEmpty(); cycle++) {
            range /= p.refinement();
            double centreX = angleX;
            double centreY = angleY;
            long most = -1;
            double slowest = 0;
            for (int j = 0; j < n; j++) {
                for (int i = 0; i < n; i++) {
                    double ax = PlainPlane.angle(centreX, i, n, range);
                    double ay = PlainPlane.angle(centreY, j, n, range);
                    Plane plane = plane(ax, ay, reference);
                    long metric = PlainPlane.metric(members, plane);
                    double speed = plane.vxPxPerS() * plane.vxPxPerS() + plane.vyPxPerS() * plane.vyPxPerS();
                    if (metric > most || metric == most && speed < slowest) {
                        most = metric;
                        slowest = speed;
                        angleX = ax;
                        angleY = ay;
                    }
                }
            }
            members = associated(members, plane(angleX, angleY, reference));
        }
    }

    /** The events on cells with |f| above mean + w sd of the occupied cells, and on occupied cells joined to them. */
    private List<Event> associated(List<Event> from, Plane plane) {
        Map<Cell, Integer> f = PlainPlane.accumulate(from, plane);
        f.values().removeIf(value -> value == 0);
        double mean = f.values().stream().mapToInt(Math::abs).sum() / (double) f.size();
        double meanSquare = f.values().stream().mapToInt(value -> value * value).sum() / (double) f.size();
        double threshold = mean + p.thresholdSd() * Math.sqrt(Math.max(0, meanSquare - mean * mean));
        Set<Cell> taken = new HashSet<>();
        Deque<Cell> fill = new ArrayDeque<>();
        f.forEach((cell, value) -> {
            if (Math.abs(value) > threshold) {
                taken.add(cell);
                fill.add(cell);
            }
        });
        while (!fill.isEmpty()) {
            Cell cell = fill.remove();
            for (long y = cell.y() - 1; y <= cell.y() + 1; y++) {
                for (long x = cell.x() - 1; x <= cell.x() + 1; x++) {
                    Cell next = new Cell(x, y);
                    if (f.containsKey(next) && taken.add(next)) {
                        fill.add(next);
                    }
                }
            }
        }
        List<Event> found = new ArrayList<>();
        for (Event e : from) {
            if (taken.contains(plane.cellOf(e))) {
                found.add(e);
            }
        }
        return found;
    }
}
