package io.github.sofas.flow.track;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.SofasParameters;
import io.github.sofas.flow.fit.MetricFit;
import io.github.sofas.flow.motion.MeasuredMotions;
import java.util.ArrayList;
import java.util.List;

/**
 * Track planes of structures that were found, until the stack adopts them. One thread may find them while another
 * labels events with those of the stack: the two share nothing before they are adopted, at a place in the stream that
 * depends on the events only.
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
     * Forgets what was found, and lets so many be found.
     *
     * @param spare planes that they are made of first, which it takes
     * @param noise how many noise events a pixel gives of either polarity, per µs
     */
    void open(int most, List<TrackPlane> spare, double noise) {
        found.clear();
        noisePerUs = noise;
        while (!spare.isEmpty()) {
            unused.add(spare.remove(spare.size() - 1));
        }
        room = most;
    }

    /** Planes are made with other parameters from now on; those that were found are with the stack. */
    void setParameters(SofasParameters.Track next) {
        p = next;
        unused.clear();
    }

    /** Lets go what was found. */
    void reset() {
        bursts.reset();
        found.forEach(TrackPlane::clear);
        unused.addAll(found);
        found.clear();
    }

    /** How many were found. */
    int size() {
        return found.size();
    }

    /** One of them, in the order in which they were found. */
    TrackPlane plane(int i) {
        return found.get(i);
    }

    /** Votes that measuring them gave since the start. */
    long votes() {
        return fit.votes();
    }

    /** Whether no further structure can be tracked. */
    public boolean isFull() {
        return found.size() >= room;
    }

    /** A plane for a new structure, whose past events are to be added before {@link #begin}. */
    public TrackPlane create(long nowUs, double vx, double vy) {
        TrackPlane plane = take();
        plane.start(nowUs, vx, vy, noisePerUs);
        return plane;
    }

    /** A plane that is not used, or one more where there is none. */
    TrackPlane take() {
        return unused.isEmpty() ? new TrackPlane(sensor, spareCells, p, measured) : unused.remove(unused.size() - 1);
    }

    /** Adds an event of the past of a new structure. */
    public void addPast(TrackPlane plane, int x, int y, long timeUs, int polarity) {
        plane.addPast(x, y, timeUs, polarity, bursts.begins(x, y, timeUs, polarity, plane.burstUs()));
    }

    /** Measures the motion of a new structure, which expects events from then on. */
    public void begin(TrackPlane plane, long nowUs) {
        plane.recentre(fit, nowUs);
        found.add(plane);
    }

    /** Gives an event to a plane that expects it, if one does. */
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
