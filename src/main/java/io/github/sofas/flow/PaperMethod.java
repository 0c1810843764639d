package io.github.sofas.flow;

import io.github.sofas.event.SensorSize;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/** The method as published: nearest cells, signed votes, a stack of track planes that are asked in turn. */
final class PaperMethod implements Method {
    private static final long CHECK_US = 5_000;

    private final SensorSize sensor;
    private final Consumer<Segment> ended;
    private SofasParameters p;
    private PaperFlowPlane flowPlane;
    private final List<PaperTrackPlane> stack = new ArrayList<>();
    private final List<PaperTrackPlane> unused = new ArrayList<>();
    private int nextId = 1;
    private long nextCheckUs = Long.MIN_VALUE;
    private float vxPxPerS;
    private float vyPxPerS;

    PaperMethod(SensorSize sensor, SofasParameters p, Consumer<Segment> ended) {
        this.sensor = sensor;
        this.p = p;
        this.ended = ended;
        flowPlane = new PaperFlowPlane(sensor.width(), sensor.height(), p);
    }

    @Override
    public int label(int x, int y, long timeUs, int polarity) {
        if (timeUs >= nextCheckUs) {
            check(timeUs);
        }
        for (int i = 0; i < stack.size(); i++) {
            PaperTrackPlane plane = stack.get(i);
            if (plane.offer(x, y, timeUs)) {
                vxPxPerS = plane.vxPxPerS;
                vyPxPerS = plane.vyPxPerS;
                return plane.id;
            }
        }
        if (flowPlane.add(x, y, timeUs, polarity)) {
            if (stack.size() < p.maxTrackPlanes()) {
                PaperTrackPlane plane = unused.isEmpty() ? new PaperTrackPlane(sensor.width(), sensor.height(), p)
                    : unused.remove(unused.size() - 1);
                plane.start(nextId++, flowPlane.structure());
                stack.add(plane);
            }
            flowPlane.release();
        }
        return 0;
    }

    @Override
    public float vxPxPerS() {
        return vxPxPerS;
    }

    @Override
    public float vyPxPerS() {
        return vyPxPerS;
    }

    /** Merges planes that describe one structure, and removes those that get too few events. */
    private void check(long nowUs) {
        nextCheckUs = nowUs + CHECK_US;
        for (int i = stack.size() - 1; i >= 0; i--) {
            if (stack.get(i).isStarved(nowUs)) {
                end(i, Segment.Fate.REMOVED, 0);
            }
        }
        for (int i = 0; i < stack.size(); i++) {
            for (int j = stack.size() - 1; j > i; j--) {
                if (stack.get(i).describesSameAs(stack.get(j))) {
                    stack.get(i).merge(stack.get(j));
                    end(j, Segment.Fate.MERGED, stack.get(i).id);
                }
            }
        }
    }

    private void end(int i, Segment.Fate fate, int mergedInto) {
        PaperTrackPlane plane = stack.remove(i);
        ended.accept(segment(plane, fate, mergedInto));
        plane.clear();
        unused.add(plane);
    }

    private static Segment segment(PaperTrackPlane plane, Segment.Fate fate, int mergedInto) {
        return new Segment(plane.id, plane.firstUs, plane.lastUs, plane.events, plane.vxPxPerS, plane.vyPxPerS,
            plane.minX, plane.minY, plane.maxX, plane.maxY, fate, mergedInto);
    }

    @Override
    public void setParameters(SofasParameters next) {
        boolean sameScale = next.velocityScalePxPerS() == p.velocityScalePxPerS();
        if (!sameScale || side(sensor.width(), next) != side(sensor.width(), p)
                || side(sensor.height(), next) != side(sensor.height(), p)) {
            endAll();
        }
        if (sameScale && next.flowProjections() == p.flowProjections() && next.rangeDeg() == p.rangeDeg()
                && next.lifespanUs() == p.lifespanUs()) {
            flowPlane.setParameters(next);
        } else {
            flowPlane = new PaperFlowPlane(sensor.width(), sensor.height(), next);
        }
        p = next;
        while (stack.size() > p.maxTrackPlanes()) {
            end(stack.size() - 1, Segment.Fate.REMOVED, 0);
        }
        for (PaperTrackPlane plane : stack) {
            plane.setParameters(p);
        }
        unused.clear();
    }

    private static int side(int sensorSide, SofasParameters p) {
        return PaperTrackPlane.side(sensorSide, p);
    }

    private void endAll() {
        while (!stack.isEmpty()) {
            end(stack.size() - 1, Segment.Fate.REMOVED, 0);
        }
    }

    @Override
    public List<Segment> segments() {
        List<Segment> list = new ArrayList<>();
        for (PaperTrackPlane plane : stack) {
            list.add(segment(plane, Segment.Fate.ALIVE, 0));
        }
        return list;
    }

    @Override
    public MetricArray metricArray() {
        return flowPlane.metricArray();
    }

    @Override
    public void contour(int id, long nowUs, PixelConsumer pixels) {
        for (int i = 0; i < stack.size(); i++) {
            if (stack.get(i).id == id) {
                stack.get(i).contour(nowUs, sensor, pixels);
            }
        }
    }

    @Override
    public void reset() {
        endAll();
        flowPlane.reset();
        nextId = 1;
        nextCheckUs = Long.MIN_VALUE;
    }
}
