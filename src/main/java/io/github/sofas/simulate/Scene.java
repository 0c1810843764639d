package io.github.sofas.simulate;

import java.util.Arrays;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;

/**
 * The scenes that can be filmed. Each scene composes its objects for the given options; the sizes, speeds and durations
 * named here are those of the default options.
 */
public enum Scene {
    /** The paper's collection of rectangles. */
    RECTANGLES("rectangles", "four rectangles, together 120 px wide, moving as one at 58 px/s", Scenes::rectangles),
    /** The paper's hexagon. */
    HEXAGON("hexagon", "a hexagon 65 px wide moving at 58 px/s", Scenes::hexagon),
    /** The paper's large circle. */
    LARGE_CIRCLE("large-circle", "a circle 70 px wide moving at 58 px/s", Scenes::largeCircle),
    /** The paper's small circle. */
    SMALL_CIRCLE("small-circle", "a circle 7 px wide moving at 58 px/s", Scenes::smallCircle),
    /** The paper's pendulum. */
    PENDULUM("pendulum", "a round bob on a pendulum of 0.72 m, let go at 23 degrees, for two swings",
            Scenes::pendulum),
    /** The paper's short rotating bar. */
    SHORT_BAR("short-bar", "a bar of 60 x 8 px turning about its centre once a second", Scenes::shortBar),
    /** The paper's long rotating bar. */
    LONG_BAR("long-bar", "a bar longer than the frame turning about its centre once a second", Scenes::longBar),
    /** Two objects that pass beside each other. */
    TWO_OPPOSITE("two-opposite", "a hexagon and a circle passing beside each other in opposite directions",
            Scenes::twoOpposite),
    /** Three objects whose paths meet. */
    THREE_CROSSING("three-crossing", "a hexagon, a circle and a square that cross in the middle, hiding each other",
            Scenes::threeCrossing),
    /** A pan past bars at four depths. */
    FOUR_BARS("four-bars", "four long bars at different depths in a camera pan, nearer ones overtake and hide others",
            Scenes::fourBars),
    /** An object that is hidden for a while. */
    PASSING_BEHIND("passing-behind", "a circle that passes behind a slower rectangle and is hidden for a while",
            Scenes::passingBehind),
    /** Two shapes that touch and part, another pair for each seed. */
    SIDE_BY_SIDE("side-by-side", "two shapes that touch and part slowly, another pair for each seed",
            SideBySide::compose),
    /** Three creatures. */
    THREE_WANDERING("three-wandering", "three long bodies that wander at random, turn and reverse, for 6 s",
            Scenes::threeWandering),
    /** The pendulum's path without its turning. */
    SWINGING_BALL("swinging-ball", "a ball on the pendulum's path that does not turn, for two swings",
            Scenes::swingingBall),
    /** The wanderers' paths without their turning. */
    WANDERING_DISCS("wandering-discs", "three discs that wander at random and reverse but do not turn, for 6 s",
            Scenes::wanderingDiscs),
    /** Many objects at once. */
    SIXTEEN("sixteen", "sixteen small shapes in four rows that pass each other", Scenes::sixteen),
    /** A camera that pans past a wall. */
    TEXTURED_PAN("textured-pan", "a textured wall sliding past at 120 px/s", TexturedScenes::pan),
    /** A camera that rolls. */
    TEXTURED_ROLL("textured-roll", "a textured wall turning about the middle at 0.45 to 1.35 rad/s",
            TexturedScenes::roll),
    /** A camera that moves forward. */
    TEXTURED_ZOOM("textured-zoom", "a textured wall growing about the middle by 35 % a second", TexturedScenes::zoom),
    /** A camera held by hand. */
    TEXTURED_HAND("textured-hand", "a textured wall sliding, turning and growing at once, each at a changing rate",
            TexturedScenes::hand),
    /** A camera that turns, with a lens as wide as most lenses. */
    TEXTURED_TURN("textured-turn", "a textured wall before a camera with a lens of 60 degrees that turns by 40",
            TexturedScenes::turn),
    /** A wall that recedes from the camera. */
    TEXTURED_SLANT("textured-slant", "a textured wall seen at a slant of 30 degrees, before a camera that slides past",
            TexturedScenes::slant),
    /** Plain shapes before a camera held by hand. */
    POSTER("poster", "shapes on a poster sliding, turning and growing at once, each at a changing rate",
            PosterScene::compose),
    /** Time to contact. */
    COMING_NEAR("coming-near", "a plain shape that comes near: its size grows from 0.45 to 1.6 in 2.8 s",
            TexturedScenes::comingNear),
    /** A plain shape that moves away from the camera: {@link #COMING_NEAR} backwards. */
    GOING_AWAY("going-away", "a plain shape that goes away: its size falls from 1.6 to 0.45 in 2.8 s",
            TexturedScenes::goingAway),
    /** Movers before a moving background. */
    TEXTURED_MOVERS("textured-movers", "three textured shapes before a textured wall, all moving",
            TexturedScenes::movers),
    /** Light without motion. */
    FLICKER("flicker", "a lamp that flickers at 100 Hz over a still textured scene, for 2 s", TexturedScenes::flicker),
    /** Random shapes, another arrangement for each seed. */
    RANDOM("random", "2 to 8 random shapes for 2.5 s, another arrangement for each seed", RandomScene::compose),
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

    /** {@return the name of the scene for users, in lower case with hyphens} */
    public String sceneName() {
        return sceneName;
    }

    /** {@return a description of the scene, in one line} */
    public String description() {
        return description;
    }

    /**
     * {@return the scene with a name, if there is one}
     *
     * @param name in lower case with hyphens
     */
    public static Optional<Scene> named(String name) {
        return Arrays.stream(values()).filter(scene -> scene.sceneName.equals(name)).findFirst();
    }

    /** {@return all names, separated by commas, for messages} */
    public static String names() {
        return Arrays.stream(values()).map(Scene::sceneName).collect(Collectors.joining(", "));
    }

    /**
     * {@return the duration of the film with these options, in µs}
     *
     * @param options how the scene is filmed
     */
    public long durationUs(SimulationOptions options) {
        return Math.max(1, Math.round(compose(options).durationS() * 1e6));
    }

    World compose(SimulationOptions options) {
        return composer.apply(options);
    }
}
