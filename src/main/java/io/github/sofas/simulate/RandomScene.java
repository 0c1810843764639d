package io.github.sofas.simulate;

import io.github.sofas.simulate.Trajectory.Journey;
import io.github.sofas.simulate.Trajectory.Pace;
import io.github.sofas.simulate.Trajectory.Sway;
import io.github.sofas.simulate.Shape.Box;
import io.github.sofas.simulate.Shape.Capsule;
import io.github.sofas.simulate.Shape.Disc;
import io.github.sofas.simulate.Shape.RegularPolygon;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/**
 * Composes a scene of two to eight opaque shapes drawn at random: size (8 to 32 px from middle to corner), outline,
 * grey, texture, speed (20 to 200 px/s), direction and depth. A third of the shapes turn; a quarter turn back or stop.
 * The background is plain, or rests with a texture, or moves with a texture. The random choices depend on the seed
 * alone; other options scale the result.
 */
final class RandomScene {
    private static final double DURATION_S = 2.5;
    private static final double SLOWEST_PX_PER_S = 20;
    private static final double FASTEST_PX_PER_S = 200;
    private static final double TEXTURED_SHARE = 0.4;
    private static final double TURNING_SHARE = 0.33;
    private static final double STOPPING_SHARE = 0.12;
    private static final double TURNING_BACK_SHARE = 0.13;
    private static final double MOVING_BACKGROUND_SHARE = 0.3;
    private static final double TEXTURED_BACKGROUND_SHARE = 0.2;

    private RandomScene() {
    }

    static World compose(SimulationOptions options) {
        Random random = Scenes.random(options);
        double durationS = Scenes.duration(options, DURATION_S);
        int count = 2 + random.nextInt(7);
        List<MovingObject> objects = new ArrayList<>();
        for (int id = 1; id <= count; id++) {
            objects.add(object(id, options, durationS, random));
        }
        double kind = random.nextDouble();
        if (kind < MOVING_BACKGROUND_SHARE + TEXTURED_BACKGROUND_SHARE) {
            double speed = kind < MOVING_BACKGROUND_SHARE ? 20 + 60 * random.nextDouble() : 0;
            double directionRad = 2 * Math.PI * random.nextDouble();
            double swing = random.nextBoolean() ? 0.5 * random.nextDouble() : 0;
            Sway trajectory = new Sway(Scenes.centreX(options), Scenes.centreY(options),
                    speed * StrictMath.cos(directionRad), speed * StrictMath.sin(directionRad), 0, 0, swing,
                    1 + 2 * random.nextDouble());
            objects.add(TexturedScenes.wall(count + 1, options, trajectory));
        }
        return new World(objects, durationS);
    }

    /**
     * Logarithm of the background's light over an object's, as a factor of the usual contrast, drawn at random: a third
     * of the objects are brighter.
     */
    static double contrast(Random random) {
        return (0.6 + 1.2 * random.nextDouble()) * (random.nextInt(3) == 0 ? -1 : 1);
    }

    private static MovingObject object(int id, SimulationOptions options, double durationS, Random random) {
        Shape shape = shape((8 + 24 * random.nextDouble()) * options.scale(), random);
        // Each octave of speed has equally many objects.
        double speed = SLOWEST_PX_PER_S
            * StrictMath.pow(FASTEST_PX_PER_S / SLOWEST_PX_PER_S, random.nextDouble());
        double directionRad = 2 * Math.PI * random.nextDouble();
        // A place and time at which the object is certain to be seen. Fast objects thus enter and leave, each at its
        // own time.
        double atX = Scenes.centreX(options) * (0.3 + 1.4 * random.nextDouble());
        double atY = Scenes.centreY(options) * (0.3 + 1.4 * random.nextDouble());
        double atS = durationS * (0.2 + 0.6 * random.nextDouble());
        double turnRadPerS = random.nextDouble() < TURNING_SHARE
            ? (0.5 + 2 * random.nextDouble()) * (random.nextBoolean() ? 1 : -1) : 0;
        double change = random.nextDouble();
        double last = change < STOPPING_SHARE ? 0 : change < STOPPING_SHARE + TURNING_BACK_SHARE ? -1 : 1;
        Pace pace = new Pace(last, durationS * (0.2 + 0.4 * random.nextDouble()), 0.2 + 0.6 * random.nextDouble());
        Trajectory trajectory = new Journey(atX, atY, atS, speed * StrictMath.cos(directionRad),
                speed * StrictMath.sin(directionRad), pace, 2 * Math.PI * random.nextDouble(), turnRadPerS);
        double contrast = contrast(random);
        Texture texture = random.nextDouble() < TEXTURED_SHARE
            ? TexturedScenes.texture(options, 0.2 + 0.3 * random.nextDouble(), new Random(random.nextLong())) : null;
        return new MovingObject(id, shape, trajectory, Scenes.dark(options, contrast), texture);
    }

    /** Draws an outline at random, with the given distance from middle to corner in px. */
    static Shape shape(double radius, Random random) {
        double aspect = 0.35 + 0.65 * random.nextDouble();
        switch (random.nextInt(4)) {
            case 0:
                return new Disc(radius);
            case 1:
                return new RegularPolygon(3 + random.nextInt(4), radius);
            case 2:
                double width = 2 * radius / Math.sqrt(1 + aspect * aspect);
                return new Box(0, 0, width, width * aspect);
            default:
                return new Capsule(2 * radius, 2 * radius * aspect);
        }
    }
}
