package io.github.sofas.flow.track;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.SofasParameters;
import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.motion.MeasuredMotions;
import java.util.ArrayList;
import java.util.List;

/**
 * Track planes of newly found structures, until the stack adopts them. One thread may find structures while another
 * labels events with the planes of the stack. The two threads share nothing until the planes are adopted, which happens
 * at a place in the event stream that depends on the events only.
 */
public final class FoundPlanes {
    private final SensorSize sensor;
    private final Contour.Spare spareCells;
    private final MeasuredMotions measured;
    private final MetricFit fit;
    private final Bursts bursts;
    private final List<TrackPlane> found = new ArrayList<>();
    private final List<TrackPlane> unused = new ArrayList<>();
    private SofasParameters.Track p;
    private int room;
    private double noisePerUs;

    FoundPlanes(SensorSize sensor, SofasParameters.Track p, MetricFit fit, MeasuredMotions measured) {
        this.sensor = sensor;
        this.p = p;
        this.fit = fit;
        this.measured = measured;
        spareCells = new Contour.Spare(sensor);
        bursts = new Bursts(sensor);
    }

    /**
     * Forgets the found planes, and allows a given number of planes to be found.
     *
     * @param spare unused planes to use first; the list is emptied
     * @param noise noise events per pixel and per µs, of each polarity
     */
    void open(int most, List<TrackPlane> spare, double noise) {
        found.clear();
        noisePerUs = noise;
        while (!spare.isEmpty()) {
            unused.add(spare.remove(spare.size() - 1));
        }
        room = most;
    }

    /** Creates planes with other parameters from now on. Planes found before are already with the stack. */
    void setParameters(SofasParameters.Track next) {
        p = next;
        unused.clear();
    }

    /** Drops the found planes. */
    void reset() {
        bursts.reset();
        found.forEach(TrackPlane::clear);
        unused.addAll(found);
        found.clear();
    }

    /** Returns the number of found planes. */
    int size() {
        return found.size();
    }

    /** Returns a found plane by its index, in the order in which the planes were found. */
    TrackPlane plane(int i) {
        return found.get(i);
    }

    /** Returns the votes that measuring found planes has given since the start. */
    long votes() {
        return fit.votes();
    }

    /** Whether no further structure can be tracked. */
    public boolean isFull() {
        return found.size() >= room;
    }

    /** Returns a plane for a new structure, whose past events are to be added before {@link #begin}. */
    public TrackPlane create(long nowUs, double vx, double vy) {
        TrackPlane plane = take();
        plane.start(nowUs, vx, vy, noisePerUs);
        return plane;
    }

    /** Returns an unused plane, or a new one if there is none. */
    TrackPlane take() {
        return unused.isEmpty() ? new TrackPlane(sensor, spareCells, p, measured) : unused.remove(unused.size() - 1);
    }

    /** Adds an event of the past of a new structure. */
    public void addPast(TrackPlane plane, int x, int y, long timeUs, int polarity) {
        plane.addPast(x, y, timeUs, polarity, bursts.begins(x, y, timeUs, polarity, plane.burstUs()));
    }

    /** Measures the motion of a new structure. From then on its plane expects events. */
    public void begin(TrackPlane plane, long nowUs) {
        plane.recentre(fit, nowUs);
        found.add(plane);
    }

    /** Gives an event to the first plane that expects it; returns whether there is one. */
    public boolean takes(int x, int y, long timeUs, int polarity) {
        for (int i = 0; i < found.size(); i++) {
            TrackPlane plane = found.get(i);
            if (plane.support(x, y, timeUs, polarity) >= plane.threshold()) {
                addPast(plane, x, y, timeUs, polarity);
                return true;
            }
        }
        return false;
    }
}
