package io.github.sofas.simulate;

import io.github.sofas.simulate.Shape.Box;
import io.github.sofas.simulate.Shape.Disc;
import io.github.sofas.simulate.Trajectory.Straight;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/**
 * Composes two shapes that about touch in the middle of the film and move almost alike: their velocities differ by 10
 * to 40 px/s, in any direction. Some rotation and growth of a single body would explain both motions. The shapes are
 * discs and squares of 12 to 24 px from the middle to the edge, plain or textured, drawn by the seed.
 */
final class SideBySide {
    private static final double DURATION_S = 1.6;
    private static final double BOX_SHARE = 0.33;
    private static final double TEXTURED_SHARE = 0.5;
    private static final double TEXTURE_SD = 0.3;
    private static final double CONTRAST = 1;

    private SideBySide() {
    }

    static World compose(SimulationOptions options) {
        Random random = Scenes.random(options);
        double durationS = Scenes.duration(options, DURATION_S);
        double speed = 40 + 80 * random.nextDouble();
        double directionRad = 2 * Math.PI * random.nextDouble();
        double apart = 10 + 30 * random.nextDouble();
        double apartRad = 2 * Math.PI * random.nextDouble();
        double[] radius = {radius(options, random), radius(options, random)};
        double sideRad = 2 * Math.PI * random.nextDouble();
        double gap = (-2 + 6 * random.nextDouble()) * options.scale();
        List<MovingObject> objects = new ArrayList<>();
        for (int id = 1; id <= 2; id++) {
            double side = id - 1.5;
            double distance = side * (radius[0] + radius[1] + gap);
            Trajectory trajectory = new Straight(Scenes.centreX(options) + distance * StrictMath.cos(sideRad),
                Scenes.centreY(options) + distance * StrictMath.sin(sideRad), durationS / 2,
                speed * StrictMath.cos(directionRad) + side * apart * StrictMath.cos(apartRad),
                speed * StrictMath.sin(directionRad) + side * apart * StrictMath.sin(apartRad), 0);
            double reach = radius[id - 1];
            Shape shape = random.nextDouble() < BOX_SHARE ? new Box(0, 0, 2 * reach, 2 * reach) : new Disc(reach);
            Texture texture = random.nextDouble() < TEXTURED_SHARE
                ? TexturedScenes.texture(options, TEXTURE_SD, new Random(random.nextLong())) : null;
            objects.add(new MovingObject(id, shape, trajectory, Scenes.dark(options, CONTRAST), texture));
        }
        return new World(objects, durationS);
    }

    private static double radius(SimulationOptions options, Random random) {
        return (12 + 12 * random.nextDouble()) * options.scale();
    }
}
