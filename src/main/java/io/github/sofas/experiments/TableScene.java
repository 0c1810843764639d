package io.github.sofas.experiments;

import io.github.sofas.simulate.Scene;
import io.github.sofas.simulate.SimulationOptions;
import io.github.sofas.simulate.Surface;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/**
 * A scene of the tables for development. The tables list textured scenes, then the scenes of the experiments, then
 * scenes that the experiments leave out; one textured scene is listed at several speeds. {@link RandomScenes} makes
 * random ones.
 *
 * @param name name of the scene in the table
 * @param scene the scene
 * @param options how the scene is filmed
 */
record TableScene(String name, Scene scene, SimulationOptions options) {
    private static final SimulationOptions PLAIN = SimulationOptions.defaults();

    /** Scenes with texture, growth and flicker; some of them also with softer surfaces. */
    static List<TableScene> textured() {
        List<TableScene> textured = new ArrayList<>();
        for (double speed : new double[] {60, 240, 1200}) {
            textured.add(new TableScene(Scene.TEXTURED_PAN.sceneName() + "-" + (int) speed, Scene.TEXTURED_PAN,
                PLAIN.withSpeedPxPerS(speed)));
        }
        Stream.of(Scene.TEXTURED_ROLL, Scene.TEXTURED_ZOOM, Scene.TEXTURED_HAND, Scene.TEXTURED_TURN,
                Scene.TEXTURED_SLANT, Scene.POSTER, Scene.COMING_NEAR, Scene.GOING_AWAY, Scene.TEXTURED_MOVERS,
                Scene.FLICKER)
            .forEach(scene -> textured.add(new TableScene(scene.sceneName(), scene, PLAIN)));
        for (Surface surface : new Surface[] {Surface.SMOOTH, Surface.FRACTAL}) {
            Stream.of(Scene.TEXTURED_HAND, Scene.TEXTURED_ZOOM, Scene.TEXTURED_MOVERS)
                .forEach(scene -> textured.add(new TableScene(scene.sceneName() + "-" + surface.surfaceName(), scene,
                    PLAIN.withSurface(surface))));
        }
        return textured;
    }

    static List<TableScene> all() {
        List<TableScene> all = textured();
        Setting.ALL.forEach(setting -> all.add(new TableScene(setting.id(), setting.scene(), setting.options())));
        Stream.of(Scene.SWINGING_BALL, Scene.WANDERING_DISCS, Scene.SIXTEEN)
            .forEach(scene -> all.add(new TableScene(scene.sceneName(), scene, PLAIN)));
        return all;
    }
}
