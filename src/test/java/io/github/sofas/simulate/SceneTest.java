package io.github.sofas.simulate;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import org.junit.Test;

public class SceneTest {
    @Test
    public void everySceneGivesEventsInOrderOnTheSensor() {
        for (Scene scene : Scene.values()) {
            SimulatedRecording film = SimulatedRecording.of(scene,
                SimulationOptions.defaults().withDurationUs(500_000));
            for (int i = 0; i < film.size(); i++) {
                assertTrue(scene.sceneName(), i == 0 || film.timeUs[i] >= film.timeUs[i - 1]);
                assertTrue(scene.sceneName(), film.sensor().contains(film.x[i], film.y[i]));
                assertTrue(scene.sceneName(), film.object[i] >= 0 && film.object[i] <= film.objects());
            }
        }
    }

    @Test
    public void sameOptionsGiveTheSameEvents() {
        SimulatedRecording first = SimulatedRecording.of(Scene.TWO_OPPOSITE, SimulationOptions.defaults());
        SimulatedRecording second = SimulatedRecording.of(Scene.TWO_OPPOSITE, SimulationOptions.defaults());
        assertArrayEquals(first.timeUs, second.timeUs);
        assertArrayEquals(first.x, second.x);
        assertArrayEquals(first.object, second.object);
        assertEquals(2, first.objects());
    }

    @Test
    public void aLampMovesNothing() {
        SimulatedRecording film = SimulatedRecording.of(Scene.FLICKER, SimulationOptions.defaults());
        int sum = 0;
        for (int i = 0; i < film.size(); i++) {
            assertEquals(0, film.object[i]);
            sum += film.polarity[i];
        }
        assertTrue("events " + film.size(), film.size() > 100_000);
        assertTrue("as many up as down", Math.abs(sum) < film.size() / 20);
    }

    @Test
    public void shapesOfAPosterAreOneBody() {
        SimulatedRecording film = SimulatedRecording.of(Scene.POSTER, SimulationOptions.defaults());
        assertEquals(1, film.objects());
        boolean[] occupied = new boolean[16];
        for (int i = 0; i < film.size(); i++) {
            if (film.object[i] != 0) {
                assertEquals(1, film.object[i]);
                occupied[film.x[i] / 60 + 4 * (film.y[i] / 45)] = true;
            }
        }
        for (boolean square : occupied) {
            assertTrue("there are shapes everywhere", square);
        }
    }

    @Test
    public void eachSeedGivesAnotherRandomSceneWithinItsBounds() {
        boolean[] counts = new boolean[9];
        int textured = 0;
        int walls = 0;
        int objects = 0;
        Pose pose = new Pose();
        for (long seed = 1; seed <= 60; seed++) {
            World world = Scene.RANDOM.compose(SimulationOptions.defaults().withSeed(seed));
            int shapes = 0;
            for (MovingObject object : world.objects()) {
                if (object.shape() instanceof Shape.Everywhere) {
                    walls++;
                    continue;
                }
                shapes++;
                object.trajectory().poseAt(0, pose);
                double speed = Math.hypot(pose.vxPxPerS, pose.vyPxPerS);
                assertTrue("speed " + speed, speed >= 20 - 1e-9 && speed <= 200 + 1e-9);
                textured += object.texture() == null ? 0 : 1;
            }
            assertTrue("shapes " + shapes, shapes >= 2 && shapes <= 8);
            counts[shapes] = true;
            objects += shapes;
        }
        for (int count = 2; count <= 8; count++) {
            assertTrue("never " + count, counts[count]);
        }
        assertEquals(0.4, (double) textured / objects, 0.08);
        assertEquals(0.5, walls / 60.0, 0.15);
    }
}
