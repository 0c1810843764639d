package io.github.sofas.simulate;

import io.github.sofas.simulate.Trajectory.Fixed;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/**
 * Composes a poster of plain shapes before a hand-held camera. The shapes are one body in many pieces, and no piece
 * shows by itself that the body turns or grows. The shapes are drawn at random, one in each square of the poster.
 */
final class PosterScene {
    private static final double SQUARE_PX = 55;
    /** Greatest distance of a shape from the middle of its square along either side, as a share of that side. */
    private static final double OFF_MIDDLE = 0.2;
    /** Distance from the middle to a corner of the smallest and of the largest shape, in px. */
    private static final double SMALLEST_PX = 6;
    private static final double LARGEST_PX = 18;
    /** Turning and growth, as a share of the turning and growth of a textured wall before such a camera. */
    private static final double TURNING = 0.25;
    private static final int BODY = 1;

    private PosterScene() {
    }

    static World compose(SimulationOptions options) {
        double durationS = TexturedScenes.byHandS(options);
        Trajectory poster = TexturedScenes.byHand(options, TURNING, durationS);
        Random random = Scenes.random(options);
        int across = (int) Math.sqrt(World.MAX_OBJECTS);
        List<MovingObject> shapes = new ArrayList<>();
        for (int square = 0; square < across * across; square++) {
            double x = place(square % across, across, random) * options.scale();
            double y = place(square / across, across, random) * options.scale();
            Trajectory fixed = new Fixed(poster, x, y, 2 * Math.PI * random.nextDouble());
            double radius = (SMALLEST_PX + (LARGEST_PX - SMALLEST_PX) * random.nextDouble()) * options.scale();
            Shape shape = RandomScene.shape(radius, random);
            shapes.add(new MovingObject(BODY, shape, fixed, Scenes.dark(options, RandomScene.contrast(random))));
        }
        return new World(shapes, durationS);
    }

    /** Position of a shape in a square along one side of the poster, from the middle of the poster, in px. */
    private static double place(int square, int across, Random random) {
        return (square - (across - 1) / 2.0 + 2 * OFF_MIDDLE * (random.nextDouble() - 0.5)) * SQUARE_PX;
    }
}
