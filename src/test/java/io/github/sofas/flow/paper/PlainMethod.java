package io.github.sofas.flow.paper;

import io.github.sofas.flow.PlainPlane.Event;
import io.github.sofas.flow.Segment;
import java.util.ArrayList;
import java.util.List;

/** The paper's stack of track planes over its flow plane, of the plain planes; {@link PaperMethod} must agree. */
final class PlainMethod {
    private final Numbers p;
    private final PlainFlowPlane flowPlane;
    final List<PlainTrackPlane> stack = new ArrayList<>();
    final List<Segment> ended = new ArrayList<>();
    private int nextId = 1;
    private boolean checkedOnce;
    private long checkedUs;

    PlainMethod(Numbers p) {
        this.p = p;
        flowPlane = new PlainFlowPlane(p);
    }

    /** The track plane that takes the event, with the velocity that it had then, or null. */
    Labelled label(Event e) {
        if (!checkedOnce || e.timeUs() >= checkedUs + 5_000) {
            checkedOnce = true;
            checkedUs = e.timeUs();
            prune(e.timeUs());
            merge();
        }
        for (PlainTrackPlane plane : stack) {
            if (plane.offer(e)) {
                return new Labelled(plane.id, (float) plane.vxPxPerS, (float) plane.vyPxPerS);
            }
        }
        if (flowPlane.add(e)) {
            if (stack.size() < p.maxTrackPlanes()) {
                stack.add(new PlainTrackPlane(p, nextId++, flowPlane.members, flowPlane.angleX,
                    flowPlane.angleY));
            }
            flowPlane.release();
        }
        return new Labelled(0, 0, 0);
    }

    record Labelled(int segment, float vxPxPerS, float vyPxPerS) {
    }

    private void prune(long nowUs) {
        for (int i = stack.size() - 1; i >= 0; i--) {
            if (stack.get(i).isStarved(nowUs)) {
                ended.add(stack.remove(i).segment(Segment.Fate.REMOVED, 0));
            }
        }
    }

    /** An older plane takes over every younger one that describes the same structure. */
    private void merge() {
        for (int i = 0; i < stack.size(); i++) {
            PlainTrackPlane older = stack.get(i);
            for (int j = stack.size() - 1; j > i; j--) {
                PlainTrackPlane younger = stack.get(j);
                if (older.describesSameAs(younger)) {
                    older.merge(younger);
                    ended.add(stack.remove(j).segment(Segment.Fate.MERGED, older.id));
                }
            }
        }
    }

    List<Segment> segments() {
        List<Segment> living = new ArrayList<>();
        for (PlainTrackPlane plane : stack) {
            living.add(plane.segment(Segment.Fate.ALIVE, 0));
        }
        return living;
    }
}
