package io.github.sofas.experiments;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import io.github.sofas.simulate.DvsModel;
import io.github.sofas.simulate.Scene;
import io.github.sofas.simulate.SimulatedRecording;
import io.github.sofas.simulate.SimulationOptions;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.Test;

public class MetricMapTest {
    private static SimulatedRecording film(Scene scene) {
        return SimulatedRecording.of(scene, SimulationOptions.defaults().withDurationUs(600_000)
            .withDvs(DvsModel.davis().withNoiseHzPerPx(0)));
    }

    @Test
    public void velocitiesAreEvenlySpacedInAngle() {
        // -80, -40, 0, 40, 80 degrees
        assertEquals(100 * Math.tan(Math.toRadians(-80)), MetricMap.velocity(0, 5), 1e-9);
        assertEquals(100 * Math.tan(Math.toRadians(40)), MetricMap.velocity(3, 5), 1e-9);
        assertEquals(0, MetricMap.velocity(2, 5), 1e-9);
        assertEquals(0.75, MetricMap.place(MetricMap.velocity(3, 5)), 1e-9);
    }

    @Test
    public void metricIsTheSumOfTheSquaredSumsOfSigns() {
        SimulatedRecording film = film(Scene.SMALL_CIRCLE);
        MetricMap map = MetricMap.of(film, 200_000, 250_000, 3);
        double[] velocities = {MetricMap.velocity(0, 3), 0, MetricMap.velocity(2, 3)};
        for (int row = 0; row < 3; row++) {
            for (int column = 0; column < 3; column++) {
                assertEquals(plainMetric(film, velocities[column], velocities[row]), map.metrics()[row][column]);
            }
        }
    }

    /** The paper's formula, written as it stands there. */
    private static long plainMetric(SimulatedRecording film, double vx, double vy) {
        Map<List<Long>, Long> f = new HashMap<>();
        for (int i = 0; i < film.size(); i++) {
            if (film.timeUs[i] >= 200_000 && film.timeUs[i] < 250_000) {
                double t = (film.timeUs[i] - 200_000) * 1e-6;
                f.merge(List.of((long) Math.floor(film.x[i] - vx * t + 0.5),
                    (long) Math.floor(film.y[i] - vy * t + 0.5)), (long) film.polarity[i], Long::sum);
            }
        }
        return f.values().stream().mapToLong(sum -> sum * sum).sum();
    }

    @Test
    public void oneObjectHasItsMaximumAtItsVelocity() {
        MetricMap.Maximum greatest = MetricMap.of(film(Scene.HEXAGON), 300_000, 400_000, 41).maxima(4, 1).get(0);
        // projections are 4 degrees apart: 9 px/s near 58 px/s, 7 px/s near 0
        assertEquals(58, greatest.vxPxPerS(), 9);
        assertEquals(0, greatest.vyPxPerS(), 7);
    }

    @Test
    public void twoOppositeMoversHaveTwoMaxima() {
        List<MetricMap.Maximum> two = MetricMap.of(film(Scene.TWO_OPPOSITE), 300_000, 400_000, 20).maxima(2, 2);
        assertEquals(2, two.size());
        assertTrue(two.get(0).vxPxPerS() * two.get(1).vxPxPerS() < 0);
    }
}
