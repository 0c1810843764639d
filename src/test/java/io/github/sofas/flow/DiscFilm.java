package io.github.sofas.flow;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.PlainPlane.Event;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.IntStream;

/** A disc that moves along the middle row of a sensor, and the labels that its events get. */
final class DiscFilm {
    static final SensorSize SENSOR = new SensorSize(200, 64);
    /** A sensor whose border cuts off the top and the bottom of the disc. */
    static final SensorSize NARROW = new SensorSize(200, 30);
    private static final double RADIUS_PX = 16;

    /** Takes an event and its label. */
    interface Labels {
        /** Takes an event of this time, the segment that it is of, and its velocity. */
        void take(double timeS, int segment, double vx, double vy);
    }

    private DiscFilm() {
    }

    /**
     * Shows a disc to an engine.
     *
     * @param centreX column of its centre by the time in s
     * @param stepS time from one look at it to the next: each pixel that its outline passes between them fires once, as
     *     if it lay a tenth of a px to one side
     */
    static void show(DoubleUnaryOperator centreX, double untilS, double stepS, Labels labels) {
        show(SENSOR, centreX, untilS, stepS, labels);
    }

    /** Shows a disc to an engine, as above, on a sensor. */
    static void show(SensorSize sensor, DoubleUnaryOperator centreX, double untilS, double stepS, Labels labels) {
        Sofas sofas = new Sofas(sensor, SofasParameters.defaults());
        EventBatch batch = new EventBatch(1);
        FlowOutput flow = new FlowOutput(1);
        for (Event e : events(sensor, centreX, untilS, stepS)) {
            batch.clear();
            batch.add(e.timeUs(), e.x(), e.y(), e.polarity());
            sofas.process(batch, flow);
            labels.take(e.timeUs() * 1e-6, flow.segment[0], flow.vxPxPerS[0], flow.vyPxPerS[0]);
        }
    }

    private static List<Event> events(SensorSize sensor, DoubleUnaryOperator centreX, double untilS, double stepS) {
        double[] centres = IntStream.iterate(0, k -> k * stepS < untilS, k -> k + 1)
            .mapToDouble(k -> centreX.applyAsDouble(k * stepS)).toArray();
        double leftmost = Arrays.stream(centres).min().orElseThrow();
        double rightmost = Arrays.stream(centres).max().orElseThrow();
        List<Event> events = new ArrayList<>();
        Random random = new Random(1);
        for (int pixel = 0; pixel < sensor.width() * sensor.height(); pixel++) {
            double x = pixel % sensor.width() + 0.1 * random.nextGaussian();
            double y = pixel / sensor.width() - sensor.height() / 2.0;
            // half of the disc along the row of the pixel
            double halfPx = Math.sqrt(Math.max(0, RADIUS_PX * RADIUS_PX - y * y));
            if (x + halfPx <= leftmost || x - halfPx >= rightmost) {
                continue;
            }
            boolean covered = Math.abs(x - centres[0]) < halfPx;
            for (int k = 1; k < centres.length; k++) {
                boolean before = covered;
                covered = Math.abs(x - centres[k]) < halfPx;
                if (covered != before) {
                    events.add(new Event(pixel % sensor.width(), pixel / sensor.width(),
                        (long) (k * stepS * 1e6) + random.nextInt(100), covered ? -1 : 1));
                }
            }
        }
        events.sort(Comparator.comparingLong(Event::timeUs));
        return events;
    }
}
