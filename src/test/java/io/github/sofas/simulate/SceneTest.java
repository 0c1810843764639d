package io.github.sofas.simulate;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import org.junit.Test;

public class SceneTest {
    @Test
    public void everySceneGivesEventsInOrderOnTheSensor() {
        for (Scene scene : Scene.values()) {
            SimulatedRecording film = SimulatedRecording.of(scene, SimulationOptions.defaults());
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
}
