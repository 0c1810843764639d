package io.github.sofas.simulate;

import java.util.Arrays;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;

/** What can be filmed. Sizes, speeds and durations named here are for the default options. */
public enum Scene {
    /** The paper's collection of rectangles. */
    RECTANGLES("rectangles", "four rectangles, together 120 px wide, moving as one at 58 px/s", Scenes::rectangles),
    /** The paper's hexagon. */
    HEXAGON("hexagon", "a hexagon 65 px wide moving at 58 px/s", Scenes::hexagon),
    /** The paper's large circle. */
    LARGE_CIRCLE("large-circle", "a circle 70 px wide moving at 58 px/s", Scenes::largeCircle),
    /** The paper's small circle. */
    SMALL_CIRCLE("small-circle", "a circle 7 px wide moving at 58 px/s", Scenes::smallCircle),
    /** Two that pass beside each other. */
    TWO_OPPOSITE("two-opposite", "a hexagon and a circle passing beside each other in opposite directions",
            Scenes::twoOpposite),
    /** Nothing at all. */
    NOISE("noise", "nothing but the sensor's own noise, for 5 s", Scenes::noise);

    private final String sceneName;
    private final String description;
    private final Function<SimulationOptions, World> composer;

    Scene(String sceneName, String description, Function<SimulationOptions, World> composer) {
        this.sceneName = sceneName;
        this.description = description;
        this.composer = composer;
    }

    /** The name that users call it by, lower case with hyphens. */
    public String sceneName() {
        return sceneName;
    }

    /** What is seen, in one line. */
    public String description() {
        return description;
    }

    /** The scene of a name, if there is one. */
    public static Optional<Scene> named(String name) {
        return Arrays.stream(values()).filter(scene -> scene.sceneName.equals(name)).findFirst();
    }

    /** All names, separated by commas, for messages. */
    public static String names() {
        return Arrays.stream(values()).map(Scene::sceneName).collect(Collectors.joining(", "));
    }

    /** How long the film is with these options, in µs. */
    public long durationUs(SimulationOptions options) {
        return Math.max(1, Math.round(compose(options).durationS() * 1e6));
    }

    World compose(SimulationOptions options) {
        return composer.apply(options);
    }
}
