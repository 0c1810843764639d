package io.github.sofas.simulate;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.SensorSize;
import io.github.sofas.simulate.Trajectory.Sway;
import io.github.sofas.simulate.Shape.Everywhere;
import java.util.List;
import java.util.Random;
import org.junit.Test;

public class TextureTest {
    private static final SensorSize SENSOR = new SensorSize(64, 48);
    private static final SimulationOptions IDEAL = SimulationOptions.defaults().withSensor(SENSOR)
            .withDvs(DvsModel.ideal());

    private final Texture texture = of(Surface.LEAVES);

    private static Texture of(Surface surface) {
        return of(surface, 2.5, 3);
    }

    private static Texture of(Surface surface, double grainPx, long seed) {
        return new Texture(surface, 128, 0.4, grainPx, 0.7, new Random(seed));
    }

    private static void assertSpread(String name, Texture its) {
        double sum = 0;
        double squares = 0;
        for (int y = 0; y < 256; y++) {
            for (int x = 0; x < 256; x++) {
                double value = its.logLightAt(x / 2.0, y / 2.0);
                sum += value;
                squares += value * value;
            }
        }
        assertEquals(name, 0, sum / 65_536, 1e-4);
        assertEquals(name, 0.16, squares / 65_536, 1e-3);
    }

    @Test
    public void hasTheSpreadThatWasAskedFor() {
        for (Surface surface : Surface.values()) {
            assertSpread(surface.surfaceName(), of(surface));
        }
    }

    @Test
    public void hasItAlsoWhereItsGrainIsLargerThanWhatIsRepeated() {
        for (Surface surface : Surface.values()) {
            assertSpread(surface.surfaceName(), of(surface, 250, 3));
        }
    }

    @Test
    public void repeatsItselfWithoutASeam() {
        for (Surface surface : Surface.values()) {
            Texture its = of(surface);
            assertEquals(its.logLightAt(3.3, 100.7), its.logLightAt(3.3 - 128, 100.7 + 256), 1e-6);
            assertEquals(its.logLightAt(127.999, 5), its.logLightAt(0, 5), 1e-2);
        }
    }

    /** Noise blurred by a Gaussian has the correlation of a Gaussian twice as wide in its square. */
    @Test
    public void smoothNoiseIsAsCorrelatedAsItsBlurMakesIt() {
        double variance = 2.5 * 2.5 + 0.7 * 0.7;
        for (double px : new double[] {2, 4, 8}) {
            assertEquals(Math.exp(-px * px / (4 * variance)), correlation(Surface.SMOOTH, px), 0.05);
        }
    }

    /** Octaves of 1.25, 2.5, 5, 10 px and of as much each; what was left of each by the optical blur weighs it. */
    @Test
    public void fractalNoiseHasAsMuchOfEachOctave() {
        for (double px : new double[] {2, 4, 8}) {
            double sum = 0;
            double all = 0;
            for (double size = 1.25; size <= 10; size *= 2) {
                double variance = size * size + 0.7 * 0.7;
                double left = size * size / variance;
                sum += left * Math.exp(-px * px / (4 * variance));
                all += left;
            }
            assertEquals(sum / all, correlation(Surface.FRACTAL, px), 0.1);
        }
    }

    /** In the mean of both axes and four tiles. */
    private static double correlation(Surface surface, double px) {
        double products = 0;
        double squares = 0;
        for (int seed = 0; seed < 4; seed++) {
            Texture its = of(surface, 2.5, seed);
            for (int y = 0; y < 128; y++) {
                for (int x = 0; x < 128; x++) {
                    double here = its.logLightAt(x, y);
                    products += here * (its.logLightAt(x + px, y) + its.logLightAt(x, y + px)) / 2;
                    squares += here * here;
                }
            }
        }
        return products / squares;
    }

    /** Rotation, growth and sliding at once; what a pixel saw at its events follows from the texture alone. */
    @Test
    public void everyEventIsAThresholdFromTheLightOfTheEventBefore() {
        Sway trajectory = new Sway(30, 20, 60, -30, 0.8, 0.3, 0.5, 0.7);
        World world = new World(List.of(new MovingObject(1, new Everywhere(), trajectory, 1, texture)), 0.8);
        SimulatedRecording film = SimulatedRecording.of(world, IDEAL);
        Pose pose = new Pose();
        trajectory.poseAt(0, pose);
        double[] level = new double[64 * 48];
        for (int pixel = 0; pixel < level.length; pixel++) {
            level[pixel] = logLight(pose, pixel % 64, pixel / 64);
        }
        double worst = 0;
        for (int i = 0; i < film.size(); i++) {
            int pixel = film.y[i] * 64 + film.x[i];
            level[pixel] += 0.2 * film.polarity[i];
            trajectory.poseAt((film.timeUs[i] + 0.5) * 1e-6, pose);
            worst = Math.max(worst, Math.abs(logLight(pose, film.x[i], film.y[i]) - level[pixel]));
        }
        assertTrue("events " + film.size(), film.size() > 10_000);
        // A quarter pixel between two drawings, joined by straight lines.
        assertTrue("off by " + worst, worst < 0.03);
    }

    private double logLight(Pose pose, int x, int y) {
        return texture.logLightAt(pose.alongX(x, y), pose.alongY(x, y));
    }

    @Test
    public void slowTextureBehindAFastShapeIsDrawnAsExactlyAsAlone() {
        Trajectory slow = new Sway(30, 20, 12, 5, 0, 0, 0, 1);
        MovingObject wall = new MovingObject(2, new Everywhere(), slow, 1, texture);
        MovingObject fast = new MovingObject(1, new Shape.Disc(3),
                new Trajectory.Straight(10, 8, 0, 300, 0, 0), 0.4);
        SimulatedRecording alone = SimulatedRecording.of(new World(List.of(wall), 1), IDEAL);
        SimulatedRecording both = SimulatedRecording.of(new World(List.of(fast, wall), 1), IDEAL);
        int[] below = {0, 0};
        long[] times = {0, 0};
        SimulatedRecording[] films = {alone, both};
        for (int k = 0; k < 2; k++) {
            for (int i = 0; i < films[k].size(); i++) {
                if (films[k].y[i] > 15) {
                    below[k]++;
                    times[k] += films[k].timeUs[i];
                    assertEquals(2, films[k].object[i]);
                }
            }
        }
        assertTrue(below[0] > 500);
        assertEquals(below[0], below[1], 0.01 * below[0]);
        assertEquals(times[0] / below[0], times[1] / below[1], 5_000);
    }
}
