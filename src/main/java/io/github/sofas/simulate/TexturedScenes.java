package io.github.sofas.simulate;

import io.github.sofas.simulate.Trajectory.Approach;
import io.github.sofas.simulate.Trajectory.Backwards;
import io.github.sofas.simulate.Trajectory.Sway;
import io.github.sofas.simulate.Scenes.Heading;
import io.github.sofas.simulate.Shape.Box;
import io.github.sofas.simulate.Shape.Disc;
import io.github.sofas.simulate.Shape.Everywhere;
import io.github.sofas.simulate.Shape.RegularPolygon;
import java.util.List;
import java.util.Random;

/**
 * Composes the scenes with texture, growth or flicker. A textured wall in the background is an object like the others,
 * with an id of its own.
 *
 * <p>The speed of a wall that turns or grows is that of points a quarter of the sensor's width from the middle.
 */
final class TexturedScenes {
    /** Texture of a wall: with thresholds of 0.2, a DAVIS240C gives 350,000 events/s at 60 px/s. */
    private static final double WALL_SD = 0.28;
    private static final double GRAIN_PX = 2.5;
    private static final int WALL_SIDE_PX = 256;
    private static final int SHAPE_SIDE_PX = 128;
    private static final double LONGEST_S = 3;
    private static final double SHORTEST_S = 0.2;

    private TexturedScenes() {
    }

    static World pan(SimulationOptions options) {
        double speed = Scenes.speed(options, 120);
        double durationS = Scenes.duration(options, travelS(240 / speed));
        Heading heading = new Heading(options);
        return new World(List.of(wall(1, options, new Sway(Scenes.centreX(options), Scenes.centreY(options),
                heading.x(speed, 0), heading.y(speed, 0), 0, 0, 0, 1))), durationS);
    }

    static World roll(SimulationOptions options) {
        double turnRadPerS = Scenes.speed(options, 0.9 * arm(options)) / arm(options);
        double durationS = Scenes.duration(options, travelS(2.5 * 0.9 / turnRadPerS));
        return new World(List.of(wall(1, options, new Sway(Scenes.centreX(options), Scenes.centreY(options), 0, 0,
                turnRadPerS, 0, 0.5, 1.5))), durationS);
    }

    static World zoom(SimulationOptions options) {
        double growthPerS = Scenes.speed(options, 0.35 * arm(options)) / arm(options);
        double durationS = Scenes.duration(options, travelS(2.5 * 0.35 / growthPerS));
        return new World(List.of(wall(1, options, new Sway(Scenes.centreX(options), Scenes.centreY(options), 0, 0, 0,
                growthPerS, 0, 1))), durationS);
    }

    static World hand(SimulationOptions options) {
        double durationS = byHandS(options);
        return new World(List.of(wall(1, options, byHand(options, 1, durationS))), durationS);
    }

    static World turn(SimulationOptions options) {
        return new World(List.of(wall(1, options, camera(options, true, 0))), byHandS(options));
    }

    /** The wall recedes as much across the camera's path as along it. */
    static World slant(SimulationOptions options) {
        double slant = StrictMath.tan(Math.PI / 6);
        return new World(List.of(wall(1, options, camera(options, false, slant))), byHandS(options));
    }

    private static CameraPath camera(SimulationOptions options, boolean turns, double slant) {
        Heading heading = new Heading(options);
        double each = slant / Math.sqrt(2);
        return new CameraPath(options.sensor().width() / 2.0 / StrictMath.tan(Math.PI / 6), Scenes.centreX(options),
                Scenes.centreY(options), heading.x(1, 0), heading.y(1, 0), byHandSpeed(options), turns,
                heading.x(each, each), heading.y(each, each), 0.6, byHandS(options));
    }

    /** Duration of the film of a hand-held camera, in s. */
    static double byHandS(SimulationOptions options) {
        return Scenes.duration(options, travelS(150 / byHandSpeed(options)));
    }

    private static double byHandSpeed(SimulationOptions options) {
        return Scenes.speed(options, 60);
    }

    /**
     * The motion of a wall before a hand-held camera.
     *
     * @param turning turn and growth, as a share of a turn of 1 rad and a growth of a third per 100 px of travel
     * @param durationS duration of the film, in s
     */
    static Trajectory byHand(SimulationOptions options, double turning, double durationS) {
        double speed = byHandSpeed(options);
        Heading heading = new Heading(options);
        double midS = durationS / 2;
        return new Sway(Scenes.centreX(options) - midS * heading.x(speed, 0),
                Scenes.centreY(options) - midS * heading.y(speed, 0), heading.x(speed, 0), heading.y(speed, 0),
                turning * speed / 100, turning * speed / 300, 0.6, durationS / 2);
    }

    static World comingNear(SimulationOptions options) {
        return nearAndFar(options, false);
    }

    static World goingAway(SimulationOptions options) {
        return nearAndFar(options, true);
    }

    /** Moves a shape nearer or farther away. The speed is that of the outline where the shape is nearest. */
    private static World nearAndFar(SimulationOptions options, boolean goesAway) {
        double radius = 34 * options.scale();
        double startScale = 0.45;
        double endScale = 1.6;
        // 1 / (contact - t) grows from 0.45 to 1.6 times its value at size 1.
        double ownS = 2.8;
        double contactShare = 1 / (1 - startScale / endScale);
        double ownSpeed = endScale * radius / (contactShare * ownS - ownS);
        double endS = ownS * ownSpeed / Scenes.speed(options, ownSpeed);
        double durationS = Math.min(endS, Scenes.duration(options, endS));
        Heading heading = new Heading(options);
        Approach approach = new Approach(Scenes.centreX(options), Scenes.centreY(options),
                heading.x(12 * options.scale(), 0), heading.y(12 * options.scale(), 0), heading.angleRad, startScale,
                contactShare * endS, durationS);
        Trajectory trajectory = goesAway ? new Backwards(approach, durationS) : approach;
        return new World(List.of(new MovingObject(1, new RegularPolygon(5, radius), trajectory,
                Scenes.dark(options, 1))), durationS);
    }

    static World movers(SimulationOptions options) {
        double k = options.scale();
        double speed = Scenes.speed(options, 90);
        double durationS = Scenes.duration(options, travelS(1.6 * 90 / speed));
        Shape[] shapes = {new Disc(26 * k), new Box(0, 0, 50 * k, 40 * k), new RegularPolygon(6, 24 * k)};
        double[] ratios = {1, 0.8, 0.7};
        double[] headings = {0, 170, 260};
        double[] alongs = {-0.05, 0.12, 0.1};
        double[] acrosses = {-0.2, 0.2, -0.12};
        double[] contrasts = {0.5, -0.5, 0.9};
        Random random = new Random(options.seed());
        MovingObject[] objects = new MovingObject[4];
        double size = Math.min(options.sensor().width(), options.sensor().height());
        Heading at = new Heading(options);
        for (int i = 0; i < 3; i++) {
            Heading heading = new Heading(options.directionDeg() + headings[i]);
            double v = ratios[i] * speed;
            double x = Scenes.centreX(options) + at.x(alongs[i] * size, acrosses[i] * size);
            double y = Scenes.centreY(options) + at.y(alongs[i] * size, acrosses[i] * size);
            Trajectory trajectory = new Trajectory.Straight(x, y, durationS / 2, heading.x(v, 0), heading.y(v, 0),
                    heading.angleRad);
            objects[i] = new MovingObject(i + 1, shapes[i], trajectory, Scenes.dark(options, contrasts[i]),
                    texture(options, SHAPE_SIDE_PX, random));
        }
        Heading against = new Heading(options.directionDeg() + 120);
        objects[3] = wall(4, options, new Sway(Scenes.centreX(options), Scenes.centreY(options),
                against.x(0.4 * speed, 0), against.y(0.4 * speed, 0), 0, 0, 0.3, durationS));
        return new World(List.of(objects), durationS);
    }

    /** Lights a scene at rest, so that its texture shows only in the way in which the light falls on it. */
    static World flicker(SimulationOptions options) {
        Heading heading = new Heading(options);
        double away = 0.15 * options.sensor().width();
        Lamp lamp = new Lamp(options.sensor(), Scenes.centreX(options) + heading.x(away, 0),
                Scenes.centreY(options) + heading.y(away, 0), 30 * options.scale(), 0.5 * options.contrast(),
                new Random(options.seed()));
        return new World(List.of(), lamp, Scenes.duration(options, 2));
    }

    /** A textured background that is everywhere. */
    static MovingObject wall(int id, SimulationOptions options, Trajectory trajectory) {
        return new MovingObject(id, new Everywhere(), trajectory, 1,
                texture(options, WALL_SIDE_PX, new Random(~options.seed())));
    }

    private static Texture texture(SimulationOptions options, int sidePx, Random random) {
        return new Texture(options.surface(), sidePx, options.texture() == 0 ? WALL_SD : options.texture(),
                GRAIN_PX * options.scale(), options.blurPx(), random);
    }

    /** The texture of a shape, with the given standard deviation of its log intensity. */
    static Texture texture(SimulationOptions options, double sd, Random random) {
        return new Texture(options.surface(), SHAPE_SIDE_PX, sd, GRAIN_PX * options.scale(), options.blurPx(),
                random);
    }

    private static double arm(SimulationOptions options) {
        return options.sensor().width() / 4.0;
    }

    private static double travelS(double seconds) {
        return Math.max(SHORTEST_S, Math.min(LONGEST_S, seconds));
    }
}
