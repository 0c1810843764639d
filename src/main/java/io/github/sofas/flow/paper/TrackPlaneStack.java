package io.github.sofas.flow.paper;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.PixelConsumer;
import io.github.sofas.flow.Segment;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/**
 * The stack of the track planes of all tracked structures (paper, section Algorithm). An event is offered to the planes
 * in turn, and goes to the first plane that it belongs to. Planes that describe one structure are merged, and planes
 * that get too few events are removed.
 */
public final class TrackPlaneStack {
    private static final long CHECK_US = 5_000;

    private final SensorSize sensor;
    private final Consumer<Segment> ended;
    private Numbers p;
    private final List<TrackPlane> planes = new ArrayList<>();
    private final List<TrackPlane> unused = new ArrayList<>();
    private int nextId = 1;
    private long nextCheckUs = Long.MIN_VALUE;

    /** Makes an empty stack, which reports each segment when it ends. */
    public TrackPlaneStack(SensorSize sensor, Numbers p, Consumer<Segment> ended) {
        this.sensor = sensor;
        this.p = p;
        this.ended = ended;
    }

    /** Upper bound of the bytes that the arrays of all track planes take. */
    public static long mostBytes(SensorSize sensor, Numbers p) {
        return p.maxTrackPlanes() * TrackPlane.mostBytes(sensor, p);
    }

    /** Offers an event to the planes in turn; returns the first plane that the event belongs to, or null. */
    public TrackPlane offer(int x, int y, long timeUs) {
        if (timeUs >= nextCheckUs) {
            check(timeUs);
        }
        for (int i = 0; i < planes.size(); i++) {
            TrackPlane plane = planes.get(i);
            if (plane.offer(x, y, timeUs)) {
                return plane;
            }
        }
        return null;
    }

    /** Begins to track a new structure, unless the greatest number of track planes is reached. */
    public void add(Refinement structure) {
        if (planes.size() < p.maxTrackPlanes()) {
            TrackPlane plane = unused.isEmpty() ? new TrackPlane(sensor.width(), sensor.height(), p)
                : unused.remove(unused.size() - 1);
            plane.start(nextId++, structure);
            planes.add(plane);
        }
    }

    /** Removes planes that get too few events, and merges planes that describe one structure. */
    private void check(long nowUs) {
        nextCheckUs = nowUs + CHECK_US;
        for (int i = planes.size() - 1; i >= 0; i--) {
            if (planes.get(i).isStarved(nowUs)) {
                end(i, Segment.Fate.REMOVED, 0);
            }
        }
        for (int i = 0; i < planes.size(); i++) {
            for (int j = planes.size() - 1; j > i; j--) {
                if (planes.get(i).describesSameAs(planes.get(j))) {
                    planes.get(i).merge(planes.get(j));
                    end(j, Segment.Fate.MERGED, planes.get(i).id);
                }
            }
        }
    }

    private void end(int i, Segment.Fate fate, int mergedInto) {
        TrackPlane plane = planes.remove(i);
        ended.accept(plane.segment(fate, mergedInto));
        plane.clear();
        unused.add(plane);
    }

    private void endAll() {
        while (!planes.isEmpty()) {
            end(planes.size() - 1, Segment.Fate.REMOVED, 0);
        }
    }

    /** Continues with other parameters. All segments end if the velocity scale or the size of accumulators changes. */
    public void setParameters(Numbers next) {
        if (next.velocityScalePxPerS() != p.velocityScalePxPerS()
                || side(sensor.width(), next) != side(sensor.width(), p)
                || side(sensor.height(), next) != side(sensor.height(), p)) {
            endAll();
        }
        p = next;
        while (planes.size() > p.maxTrackPlanes()) {
            end(planes.size() - 1, Segment.Fate.REMOVED, 0);
        }
        for (TrackPlane plane : planes) {
            plane.setParameters(p);
        }
        unused.clear();
    }

    private static int side(int sensorSide, Numbers p) {
        return TrackPlane.side(sensorSide, p);
    }

    /** The living segments. */
    public List<Segment> segments() {
        List<Segment> list = new ArrayList<>();
        for (TrackPlane plane : planes) {
            list.add(plane.segment(Segment.Fate.ALIVE, 0));
        }
        return list;
    }

    /** Passes on the pixels of a living segment's contour that lie on the sensor; none for any other id. */
    public void contour(int id, long nowUs, PixelConsumer pixels) {
        for (int i = 0; i < planes.size(); i++) {
            if (planes.get(i).id == id) {
                planes.get(i).contour(nowUs, sensor, pixels);
            }
        }
    }

    /** Ends all segments, and numbers new ones from 1 again. */
    public void reset() {
        endAll();
        nextId = 1;
        nextCheckUs = Long.MIN_VALUE;
    }
}
