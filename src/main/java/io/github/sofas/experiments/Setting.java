package io.github.sofas.experiments;

import io.github.sofas.simulate.Scene;
import io.github.sofas.simulate.SimulationOptions;
import java.util.ArrayList;
import java.util.List;

/**
 * A setting of the experiments: a scene, the options with which it is filmed, and goals. The scene is filmed by a
 * simulated DAVIS240C with 0.1 Hz of noise per pixel unless stated otherwise.
 *
 * @param id name of the setting in the CSV files, and of its anchor in the report
 * @param title name of the setting for people
 * @param scene the scene
 * @param options how the scene is filmed
 * @param goals what the default preset should reach in the setting
 */
record Setting(String id, String title, Scene scene, SimulationOptions options, List<Goal> goals) {
    private static final SimulationOptions PLAIN = SimulationOptions.defaults();

    static final Setting RECTANGLES = shape("rectangles", "Rectangles, 58 px/s", Scene.RECTANGLES, PLAIN,
        Goal.flow(0.5, 1.5, 0.3, 1.5, 99));
    static final Setting HEXAGON = shape("hexagon", "Hexagon, 58 px/s", Scene.HEXAGON, PLAIN,
        Goal.flow(0.5, 1.5, 0.3, 1.5, 99));
    static final Setting LARGE_CIRCLE = shape("large-circle", "Large circle, 58 px/s", Scene.LARGE_CIRCLE, PLAIN,
        Goal.flow(0.5, 1.5, 0.3, 1.5, 99));
    static final Setting SMALL_CIRCLE = shape("small-circle", "Small circle (7 px), 58 px/s", Scene.SMALL_CIRCLE,
        PLAIN, Goal.flow(1, 2, 0.5, 2, 98));
    static final Setting HEXAGON_35_DEG = shape("hexagon-35-degrees", "Hexagon, 58 px/s at 35°", Scene.HEXAGON,
        PLAIN.withDirectionDeg(35), Goal.flow(0.5, 1.5, 0.3, 1.5, 99));
    static final Setting HEXAGON_SLOW = shape("hexagon-5.8", "Hexagon, 5.8 px/s", Scene.HEXAGON,
        PLAIN.withSpeedPxPerS(5.8), Goal.flow(1, 2, 0.5, 2, 98));
    static final Setting HEXAGON_FAST = shape("hexagon-289", "Hexagon, 289 px/s", Scene.HEXAGON,
        PLAIN.withSpeedPxPerS(289), Goal.flow(1, 2, 0.5, 2, 98));
    static final Setting HEXAGON_NOISY = shape("hexagon-noisy", "Hexagon, 1 Hz/px noise, 20 hot pixels", Scene.HEXAGON,
        PLAIN.withDvs(PLAIN.dvs().withNoiseHzPerPx(1).withHotPixels(20, PLAIN.dvs().hotPixelHz())),
        plus(Goal.flow(1, 2, 0.5, 2, 98), Goal.noise(10)));
    static final Setting PENDULUM = new Setting("pendulum", "Pendulum", Scene.PENDULUM, PLAIN,
        List.of(Goal.endpointOfPeak(3), Goal.share(95)));
    static final Setting SHORT_BAR = new Setting("short-bar", "Short rotating bar", Scene.SHORT_BAR, PLAIN,
        List.of(Goal.relativeEndpointBelow(ComparedMethod.LOCAL_PLANES), Goal.share(80)));
    static final Setting LONG_BAR = new Setting("long-bar", "Long rotating bar", Scene.LONG_BAR, PLAIN, List.of());
    static final Setting TWO_OPPOSITE = new Setting("two-opposite", "Two opposite movers", Scene.TWO_OPPOSITE, PLAIN,
        List.of(Goal.iou(0.97), Goal.parts(1.05), Goal.firstLabelled()));
    static final Setting THREE_CROSSING = new Setting("three-crossing", "Three that cross", Scene.THREE_CROSSING,
        PLAIN, List.of(Goal.iou(0.95), Goal.parts(1.1), Goal.firstLabelled()));
    static final Setting THREE_WANDERING = new Setting("three-wandering", "Three that wander", Scene.THREE_WANDERING,
        PLAIN, List.of(Goal.iou(0.9)));
    static final Setting FOUR_BARS = new Setting("four-bars", "Pan past bars at four depths", Scene.FOUR_BARS, PLAIN,
        List.of(Goal.iou(0.9)));
    static final Setting PASSING_BEHIND = new Setting("passing-behind", "One passes behind another",
        Scene.PASSING_BEHIND, PLAIN, List.of(Goal.iou(0.9)));

    /** The four shapes of the paper's comparison. */
    static final List<Setting> SHAPES = List.of(RECTANGLES, HEXAGON, LARGE_CIRCLE, SMALL_CIRCLE);
    /** The paper's three velocities. */
    static final List<Setting> VELOCITIES = List.of(HEXAGON_SLOW, HEXAGON, HEXAGON_FAST);
    /** The paper's rotating bars. */
    static final List<Setting> BARS = List.of(SHORT_BAR, LONG_BAR);
    /** Scenes of several objects; the first three are of the kinds that the paper's last figure shows. */
    static final List<Setting> SEVERAL = List.of(THREE_WANDERING, FOUR_BARS, PASSING_BEHIND, TWO_OPPOSITE,
        THREE_CROSSING);
    /** The settings of which pictures are made. */
    static final List<Setting> PICTURED = List.of(SHORT_BAR, LONG_BAR, THREE_WANDERING, FOUR_BARS, PASSING_BEHIND,
        THREE_CROSSING);
    /** All settings, in the order of the report. */
    static final List<Setting> ALL = List.of(RECTANGLES, HEXAGON, LARGE_CIRCLE, SMALL_CIRCLE, HEXAGON_35_DEG,
        HEXAGON_SLOW, HEXAGON_FAST, HEXAGON_NOISY, PENDULUM, SHORT_BAR, LONG_BAR, THREE_WANDERING, FOUR_BARS,
        PASSING_BEHIND, TWO_OPPOSITE, THREE_CROSSING);

    private static Setting shape(String id, String title, Scene scene, SimulationOptions options, List<Goal> flow) {
        return new Setting(id, title, scene, options, plus(flow, Goal.firstLabelled()));
    }

    private static List<Goal> plus(List<Goal> goals, Goal more) {
        List<Goal> all = new ArrayList<>(goals);
        all.add(more);
        return List.copyOf(all);
    }
}
