package io.github.sofas.flow;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.PlainPlane.Event;
import io.github.sofas.simulate.Scene;
import io.github.sofas.simulate.SimulatedRecording;
import io.github.sofas.simulate.SimulationOptions;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/** Events for tests of the method: drawn by hand, filmed, or by chance with a fixed seed. */
public final class Streams {
    private Streams() {
    }

    /**
     * A straight upright edge, rows [0, rows), that fires once in every column that it enters.
     *
     * @param first column that it enters at startUs
     * @param columnUs time that it needs for a column, negative where it moves left
     */
    public static List<Event> edge(int first, int columns, int rows, long startUs, long columnUs) {
        List<Event> events = new ArrayList<>();
        for (int c = 0; c < columns; c++) {
            for (int y = 0; y < rows; y++) {
                int x = first + (columnUs > 0 ? c : -c);
                events.add(new Event(x, y, startUs + c * Math.abs(columnUs), 1));
            }
        }
        return events;
    }

    /** The first events of a scene on a small sensor. */
    public static List<Event> filmed(Scene scene, SensorSize sensor, double scale, double directionDeg, int most) {
        SimulatedRecording film = SimulatedRecording.of(scene, SimulationOptions.defaults().withSensor(sensor)
            .withScale(scale).withDirectionDeg(directionDeg));
        List<Event> events = new ArrayList<>();
        for (int i = 0; i < Math.min(most, film.size()); i++) {
            events.add(new Event(film.x[i], film.y[i], film.timeUs[i], film.polarity[i]));
        }
        return events;
    }

    /** The same events at other times. */
    public static List<Event> later(List<Event> events, long us) {
        List<Event> moved = new ArrayList<>();
        for (Event e : events) {
            moved.add(new Event(e.x(), e.y(), e.timeUs() + us, e.polarity()));
        }
        return moved;
    }

    /**
     * Dots that wander over the sensor among noise: some events at one time, some after a gap, one gap in five hundred
     * of many seconds.
     */
    public static List<Event> chance(long seed, SensorSize sensor, int count, long startUs, int meanGapUs) {
        Random random = new Random(seed);
        List<Event> events = new ArrayList<>();
        double[] x = new double[6];
        double[] y = new double[6];
        double[] vx = new double[6];
        double[] vy = new double[6];
        for (int d = 0; d < x.length; d++) {
            x[d] = random.nextDouble() * sensor.width();
            y[d] = random.nextDouble() * sensor.height();
            // two groups of three that move alike
            vx[d] = d < 3 ? 40 : -90;
            vy[d] = d < 3 ? -25 : 60;
        }
        long t = startUs;
        while (events.size() < count) {
            long gap = random.nextInt(3) == 0 ? 0 : random.nextInt(2 * meanGapUs);
            if (random.nextInt(500) == 0) {
                gap = random.nextInt(20_000_000);
            }
            t += gap;
            int polarity = random.nextInt(4) == 0 ? -1 : 1;
            if (random.nextInt(5) == 0) {
                events.add(new Event(random.nextInt(sensor.width()), random.nextInt(sensor.height()), t, polarity));
                continue;
            }
            int d = random.nextInt(x.length);
            double s = (t - startUs) * 1e-6;
            int column = (int) Math.floorMod(Math.round(x[d] + vx[d] * s), (long) sensor.width());
            int row = (int) Math.floorMod(Math.round(y[d] + vy[d] * s), (long) sensor.height());
            events.add(new Event(column, row, t, polarity));
        }
        return events;
    }

    /** All events in one batch. */
    public static EventBatch batch(List<Event> events) {
        EventBatch batch = new EventBatch(Math.max(1, events.size()));
        for (Event e : events) {
            batch.add(e.timeUs(), e.x(), e.y(), e.polarity());
        }
        return batch;
    }
}
