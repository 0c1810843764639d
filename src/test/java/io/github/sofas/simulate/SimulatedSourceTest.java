package io.github.sofas.simulate;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import io.github.sofas.simulate.Trajectory.Straight;
import io.github.sofas.simulate.Shape.Box;
import io.github.sofas.simulate.Shape.Disc;
import java.util.Arrays;
import java.util.List;
import org.junit.Test;

public class SimulatedSourceTest {
    private static final SimulationOptions IDEAL = SimulationOptions.defaults().withDvs(DvsModel.ideal());

    /** Half the plane is dark: the upright edge is at x = 0 at time 0 and moves right at 100 px/s. */
    private static SimulatedRecording movingEdge(double contrast, SensorSize sensor, double durationS) {
        MovingObject dark = new MovingObject(1, new Box(-500, 0, 1000, 1000), new Straight(0, 0, 0, 100, 0, 0),
                Math.exp(-contrast));
        return SimulatedRecording.of(new World(List.of(dark), durationS), IDEAL.withSensor(sensor));
    }

    @Test
    public void edgeCrossesEachPixelWhenItIsThere() {
        // Log light falls from 0 to -0.4001. The event at the threshold of 0.2 comes when the coverage c meets
        // 1 - c (1 - e^-0.4001) = e^-0.2, c = 0.54989: 1/2 - 3/4 u + u^3/4 = 0.54989 gives u = -0.06661, so the edge
        // is 0.06661 * 0.7 * sqrt 5 = 0.10426 px beyond the pixel's centre. Column x: (x + 0.10426) / 100 s.
        SimulatedRecording film = movingEdge(0.4001, new SensorSize(40, 1), 0.3);
        for (int column = 5; column < 25; column++) {
            int wanted = column;
            long[] times = eventTimes(film, wanted);
            assertEquals("events in column " + column, 2, times.length);
            assertEquals(10_000 * column + 1043, times[0], 20);
        }
    }

    @Test
    public void edgeFiresOncePerThresholdInItsContrast() {
        // floor(0.7 / 0.2) = 3 events, all OFF, of object 1, at 100 px/s.
        SimulatedRecording film = movingEdge(0.7, new SensorSize(40, 4), 0.3);
        assertEquals(3, eventTimes(film, 10).length / 4);
        for (int i = 0; i < film.size(); i++) {
            assertEquals(-1, film.polarity[i]);
            assertEquals(1, film.object[i]);
            assertEquals(100f, film.vxPxPerS[i], 0);
            assertEquals(0f, film.vyPxPerS[i], 0);
        }
    }

    private static long[] eventTimes(SimulatedRecording film, int column) {
        long[] times = new long[film.size()];
        int count = 0;
        for (int i = 0; i < film.size(); i++) {
            if (film.x[i] == column) {
                times[count++] = film.timeUs[i];
            }
        }
        return Arrays.copyOf(times, count);
    }

    @Test
    public void everyEventLiesNearTheOutlineOrOnTheTextureOfTheObjectThatCausedIt() {
        SimulationOptions options = IDEAL.withDirectionDeg(35).withDurationUs(500_000);
        for (Scene scene : Scene.values()) {
            World world = scene.compose(options);
            SimulatedRecording film = SimulatedRecording.of(world, options);
            Pose pose = new Pose();
            for (int i = 0; i < film.size(); i += 7) {
                int id = film.object[i];
                if (id == 0) {
                    assertEquals("only a lamp makes events without an object", Scene.FLICKER, scene);
                    continue;
                }
                double outside = Double.POSITIVE_INFINITY;
                for (MovingObject cause : world.objects()) {
                    if (cause.id() == id) {
                        cause.trajectory().poseAt(film.timeUs[i] * 1e-6, pose);
                        double distance = pose.distanceTo(cause.shape(), film.x[i], film.y[i]);
                        outside = Math.min(outside, cause.texture() == null ? Math.abs(distance) : distance);
                    }
                }
                // 0.7 px of blur reach 1.57 px; a step moves 0.25 px at most.
                assertTrue(scene + " " + outside, outside < 1.57 + 0.25);
                assertEquals(pose.vxAt(film.x[i], film.y[i]), film.vxPxPerS[i], 0.1);
                assertEquals(pose.vyAt(film.x[i], film.y[i]), film.vyPxPerS[i], 0.1);
            }
        }
    }

    @Test
    public void objectInFrontHidesTheOneBehind() {
        SensorSize sensor = new SensorSize(100, 60);
        Box wall = new Box(0, 0, 40, 200);
        World world = new World(List.of(
                new MovingObject(2, wall, new Straight(50, 30, 0, 0, 0, 0), 0.5),
                new MovingObject(1, new Disc(8), new Straight(-10, 30, 0, 100, 0, 0), 0.3)), 1.2);
        SimulatedRecording film = SimulatedRecording.of(world, IDEAL.withSensor(sensor));
        int[] events = new int[100];
        for (int i = 0; i < film.size(); i++) {
            // The wall rests, so it causes nothing.
            assertEquals(1, film.object[i]);
            events[film.x[i]]++;
        }
        // The wall covers columns 30 to 70, blurred by 1.57 px.
        for (int column = 32; column <= 68; column++) {
            assertEquals("column " + column, 0, events[column]);
        }
        assertTrue(events[20] > 0 && events[80] > 0);
    }

    @Test
    public void edgeInFrontTakesTheBlameWhereBothMove() {
        // Two edges side by side at the same place, moving together: only the one in front is seen.
        SensorSize sensor = new SensorSize(60, 10);
        World world = new World(List.of(
                new MovingObject(1, new Box(-50, 0, 100, 100), new Straight(0, 0, 0, 100, 0, 0), 0.4),
                new MovingObject(2, new Box(-52, 0, 100, 100), new Straight(0, 0, 0, 100, 0, 0), 0.4)), 0.4);
        SimulatedRecording film = SimulatedRecording.of(world, IDEAL.withSensor(sensor));
        assertTrue(film.size() > 0);
        assertTrue(Arrays.stream(film.object).allMatch(id -> id == 1));
    }

    @Test
    public void noiseComesAtItsRateInBothPolarities() {
        // 2 Hz on 100 x 100 px for 5 s: 100,000 events expected, standard deviation 316.
        SimulatedRecording film = SimulatedRecording.of(Scene.NOISE, IDEAL.withSensor(new SensorSize(100, 100))
                .withDvs(DvsModel.ideal().withNoiseHzPerPx(2)));
        assertEquals(100_000, film.size(), 4 * 316);
        int on = 0;
        for (int i = 0; i < film.size(); i++) {
            on += film.polarity[i] > 0 ? 1 : 0;
            assertEquals(0, film.object[i]);
        }
        assertEquals(film.size() / 2, on, 4 * 158);
    }

    @Test
    public void hotPixelsFireByThemselves() {
        // 20 pixels at 50 Hz for 5 s: 5000 events expected, standard deviation 71.
        SimulatedRecording film = SimulatedRecording.of(Scene.NOISE, IDEAL.withDvs(DvsModel.ideal()
                .withHotPixels(20, 50)));
        assertEquals(5000, film.size(), 4 * 71);
        boolean[] hot = new boolean[240 * 180];
        int pixels = 0;
        for (int i = 0; i < film.size(); i++) {
            int pixel = film.y[i] * 240 + film.x[i];
            pixels += hot[pixel] ? 0 : 1;
            hot[pixel] = true;
            assertEquals(1, film.polarity[i]);
        }
        assertEquals(20, pixels);
    }

    @Test
    public void sameSeedGivesTheSameEventsAndAnotherGivesOthers() {
        SimulationOptions options = SimulationOptions.defaults().withDurationUs(300_000);
        SimulatedRecording first = SimulatedRecording.of(Scene.THREE_WANDERING, options);
        SimulatedRecording again = SimulatedRecording.of(Scene.THREE_WANDERING, options);
        SimulatedRecording other = SimulatedRecording.of(Scene.THREE_WANDERING, options.withSeed(2));
        assertArrayEquals(first.timeUs, again.timeUs);
        assertArrayEquals(first.x, again.x);
        assertArrayEquals(first.y, again.y);
        assertArrayEquals(first.polarity, again.polarity);
        assertArrayEquals(first.vxPxPerS, again.vxPxPerS, 0);
        assertArrayEquals(first.object, again.object);
        assertFalse(Arrays.equals(first.timeUs, other.timeUs));
    }

    @Test
    public void sizeOfTheBatchDoesNotMatter() {
        SimulationOptions options = SimulationOptions.defaults().withDurationUs(200_000);
        SimulatedRecording whole = SimulatedRecording.of(Scene.HEXAGON, options);
        SimulatedSource source = new SimulatedSource(Scene.HEXAGON, options);
        EventBatch batch = new EventBatch(7);
        Truth truth = new Truth(7);
        int n = 0;
        while (source.next(batch, truth)) {
            for (int i = 0; i < batch.size(); i++, n++) {
                assertEquals(whole.timeUs[n], batch.timeUs[i]);
                assertEquals(whole.object[n], truth.object[i]);
            }
        }
        assertEquals(whole.size(), n);
        assertEquals(0, batch.size());
    }

    @Test
    public void passesFollowEachOtherInTime() {
        SimulationOptions options = SimulationOptions.defaults().withDurationUs(200_000);
        SimulatedSource source = new SimulatedSource(Scene.TWO_OPPOSITE, options, 3);
        EventBatch batch = new EventBatch(1000);
        long last = 0;
        int[] perPass = new int[3];
        while (source.next(batch)) {
            for (int i = 0; i < batch.size(); i++) {
                assertTrue(batch.timeUs[i] >= last);
                last = batch.timeUs[i];
                perPass[(int) Math.min(2, last / 200_000)]++;
            }
        }
        // Nothing fires when the objects jump back, so all passes are about alike.
        assertEquals(perPass[0], perPass[1], 0.1 * perPass[0]);
        assertEquals(perPass[0], perPass[2], 0.1 * perPass[0]);
    }

    @Test
    public void wholeShapeStaysOnTheSensor() {
        for (double speed : new double[] {5.8, 58, 289}) {
            for (double direction : new double[] {0, 35, 90, 200}) {
                SimulationOptions options = SimulationOptions.defaults().withSpeedPxPerS(speed)
                        .withDirectionDeg(direction);
                World world = Scene.HEXAGON.compose(options);
                MovingObject hexagon = world.objects().get(0);
                Pose pose = new Pose();
                for (double time : new double[] {0, world.durationS()}) {
                    hexagon.trajectory().poseAt(time, pose);
                    assertTrue(pose.x - 32.5 >= 3 - 1e-9 && pose.x + 32.5 <= 236 + 1e-9);
                    assertTrue(pose.y - 28.1 >= 3 - 0.1 && pose.y + 28.1 <= 176 + 0.1);
                    assertEquals(speed, Math.hypot(pose.vxPxPerS, pose.vyPxPerS), 1e-9);
                }
                assertTrue(world.durationS() * speed > 100);
            }
        }
    }

    @Test
    public void refusesTruthSmallerThanTheBatch() {
        SimulatedSource source = new SimulatedSource(Scene.NOISE, SimulationOptions.defaults());
        IllegalArgumentException refused = assertThrows(IllegalArgumentException.class,
                () -> source.next(new EventBatch(10), new Truth(9)));
        assertEquals("truth must hold at least 10 events, as the batch does, but holds 9", refused.getMessage());
    }

    @Test
    public void refusesOptionsOutOfRange() {
        assertEquals("scale must be positive but was 0.0",
                assertThrows(IllegalArgumentException.class, () -> IDEAL.withScale(0)).getMessage());
        assertEquals("speedPxPerS must not be negative but was -1.0",
                assertThrows(IllegalArgumentException.class, () -> IDEAL.withSpeedPxPerS(-1)).getMessage());
        assertEquals("noiseHzPerPx must not be negative but was -0.5", assertThrows(IllegalArgumentException.class,
                () -> DvsModel.davis().withNoiseHzPerPx(-0.5)).getMessage());
        assertEquals("onThreshold must be positive but was 0.0", assertThrows(IllegalArgumentException.class,
                () -> DvsModel.davis().withThresholds(0, 0.2)).getMessage());
    }
}
