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
 * What the engine knew after a packet, to be drawn while it labels the next.
 *
 * @param sensor whose events it labels
 * @param parameters that it labels with
 * @param segments that are tracked
 * @param contours x and y in turn of each segment's contour cells; empty where they are not shown
 * @param metrics of the flow plane; null where they are not shown
 */
record Snapshot(SensorSize sensor, SofasParameters parameters, List<Segment> segments, List<short[]> contours,
                MetricArray metrics) {

    /** Takes down what is there now. */
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
