package io.github.sofas.jaer;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.MetricArray;
import io.github.sofas.flow.Segment;
import io.github.sofas.flow.Sofas;
import io.github.sofas.flow.SofasParameters;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The state of the engine after a packet, as far as it is drawn. The viewer draws this copy while the engine labels the
 * next packet.
 *
 * @param sensor size of the sensor
 * @param parameters parameters of the engine
 * @param segments segments that are tracked
 * @param contours contour cells of each segment, x and y in turn; empty if they are not shown
 * @param metrics metrics of the flow plane; null if they are not shown
 */
record Snapshot(SensorSize sensor, SofasParameters parameters, List<Segment> segments, List<short[]> contours,
                MetricArray metrics) {

    /** Copies the present state of an engine. */
    static Snapshot of(Sofas sofas, boolean withContours, boolean withMetrics) {
        List<Segment> segments = sofas.segments();
        List<short[]> contours = new ArrayList<>();
        if (withContours) {
            for (Segment segment : segments) {
                contours.add(contour(sofas, segment.id()));
            }
        }
        return new Snapshot(sofas.sensor(), sofas.parameters(), segments, contours,
            withMetrics ? sofas.metricArray() : null);
    }

    private static short[] contour(Sofas sofas, int id) {
        short[][] cells = {new short[1024]};
        int[] count = new int[1];
        sofas.contour(id, (x, y) -> {
            if (count[0] == cells[0].length) {
                cells[0] = Arrays.copyOf(cells[0], 2 * count[0]);
            }
            cells[0][count[0]++] = (short) x;
            cells[0][count[0]++] = (short) y;
        });
        return Arrays.copyOf(cells[0], count[0]);
    }
}
