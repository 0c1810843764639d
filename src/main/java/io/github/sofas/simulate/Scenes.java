package io.github.sofas.simulate;

import io.github.sofas.simulate.Trajectory.Rotation;
import io.github.sofas.simulate.Trajectory.Straight;
import io.github.sofas.simulate.Trajectory.ThereAndBack;
import io.github.sofas.simulate.Shape.Box;
import io.github.sofas.simulate.Shape.Capsule;
import io.github.sofas.simulate.Shape.Disc;
import io.github.sofas.simulate.Shape.RegularPolygon;
import io.github.sofas.simulate.Shape.Union;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.function.IntFunction;

/**
 * Composes the scenes of plain objects: arranges the objects of each scene for a sensor of any size, with the speed,
 * direction and duration of the options.
 */
final class Scenes {
    /** The paper's speed of its four shapes, in px/s. */
    static final double PAPER_SPEED_PX_PER_S = 58;

    /** Room left between an object and the sensor's border, so that blurred edges stay visible, in px. */
    private static final double BORDER_PX = 3;
    private static final double LONGEST_S = 5;
    private static final double SHORTEST_TRAVEL_PX = 120;
    private static final double NOISE_S = 5;

    private Scenes() {
    }

    static World rectangles(SimulationOptions options) {
        double k = options.scale();
        Shape shape = new Union(
                new Box(-48 * k, -4 * k, 24 * k, 52 * k),
                new Box(-7 * k, 10 * k, 34 * k, 44 * k),
                new Box(41 * k, -20 * k, 38 * k, 26 * k),
                new Box(38 * k, 21 * k, 20 * k, 24 * k));
        return oneShape(options, shape);
    }

    static World hexagon(SimulationOptions options) {
        return oneShape(options, new RegularPolygon(6, 65 / 2.0 * options.scale()));
    }

    static World largeCircle(SimulationOptions options) {
        return oneShape(options, new Disc(70 / 2.0 * options.scale()));
    }

    static World smallCircle(SimulationOptions options) {
        return oneShape(options, new Disc(7 / 2.0 * options.scale()));
    }

    /**
     * Moves one object through the sensor's centre, inside the sensor from first to last. The film covers the whole
     * path, but no more than five seconds or, for a slow object, 120 px. A shape too large to travel a quarter of its
     * own width inside the sensor enters and leaves instead: its centre crosses the sensor.
     */
    private static World oneShape(SimulationOptions options, Shape shape) {
        double speed = speed(options, PAPER_SPEED_PX_PER_S);
        Heading heading = new Heading(options);
        double insideS = alongS(options, shape, speed);
        if (insideS * speed < shape.radius() / 2) {
            insideS = alongS(options, new Disc(0), speed);
        }
        double durationS = duration(options, Math.min(insideS, Math.max(LONGEST_S, SHORTEST_TRAVEL_PX / speed)));
        return new World(List.of(new MovingObject(1, shape, through(options, heading, 0, 0, speed, 0, durationS),
                dark(options, 1))), durationS);
    }

    /**
     * Shows the bob alone: its rod is as light as the background. The swing fills the sensor's width unless the options
     * give a field of view or a peak speed.
     */
    static World pendulum(SimulationOptions options) {
        double bobRadius = 15 * options.scale();
        double halfSwingM = Pendulum.LENGTH_M * StrictMath.sin(Pendulum.MAX_ANGLE_RAD);
        double room = alongS(options, new Disc(bobRadius), 1) / 2;
        double pxPerM = Math.max(room, bobRadius) / halfSwingM;
        if (options.speedPxPerS() > 0) {
            pxPerM = options.speedPxPerS() / Pendulum.peakSpeedMPerS();
        } else if (options.fieldOfViewM() > 0) {
            pxPerM = options.sensor().width() / options.fieldOfViewM();
        }
        double sagPx = Pendulum.LENGTH_M * (1 - StrictMath.cos(Pendulum.MAX_ANGLE_RAD)) * pxPerM;
        Heading heading = new Heading(options);
        Pendulum trajectory = new Pendulum(centreX(options) + heading.x(0, sagPx / 2),
                centreY(options) + heading.y(0, sagPx / 2), pxPerM, heading.angleRad);
        return new World(List.of(new MovingObject(1, new Disc(bobRadius), trajectory, dark(options, 1))),
                duration(options, 2 * trajectory.periodS()));
    }

    /** Moves the bob along the pendulum's path, but at a constant angle: it does not turn with the rod. */
    static World swingingBall(SimulationOptions options) {
        return notTurning(pendulum(options));
    }

    private static World notTurning(World world) {
        return new World(world.objects().stream().map(object -> new MovingObject(object.id(), object.shape(),
                new Trajectory.NotTurning(object.trajectory()), object.light())).toList(), world.durationS());
    }

    static World shortBar(SimulationOptions options) {
        return rotating(options, new Box(0, 0, 60 * options.scale(), 8 * options.scale()));
    }

    static World longBar(SimulationOptions options) {
        double width = options.sensor().width();
        double height = options.sensor().height();
        double longEnough = 1.2 * Math.sqrt(width * width + height * height);
        return rotating(options, new Box(0, 0, longEnough, 12 * options.scale()));
    }

    private static World rotating(SimulationOptions options, Shape bar) {
        Rotation trajectory = new Rotation(centreX(options), centreY(options), new Heading(options).angleRad,
                2 * Math.PI * options.turnsPerS());
        return new World(List.of(new MovingObject(1, bar, trajectory, dark(options, 1))),
                duration(options, 2 / Math.abs(options.turnsPerS())));
    }

    static World twoOpposite(SimulationOptions options) {
        double k = options.scale();
        Shape hexagon = new RegularPolygon(6, 24 * k);
        Shape disc = new Disc(22 * k);
        double aside = Math.max(0.23 * Math.min(options.sensor().width(), options.sensor().height()), 27 * k);
        double speed = speed(options, PAPER_SPEED_PX_PER_S);
        Heading heading = new Heading(options);
        double insideS = Math.min(insideS(options, hexagon, 0, heading, -aside, speed),
                insideS(options, disc, 0, heading, aside, -1.25 * speed));
        double durationS = duration(options, Math.max(insideS, SHORTEST_TRAVEL_PX / 2 / speed));
        return new World(List.of(
                new MovingObject(1, hexagon, through(options, heading, 0, -aside, speed, 0, durationS),
                        dark(options, 1)),
                new MovingObject(2, disc, through(options, heading, 0, aside, -1.25 * speed, 0, durationS),
                        dark(options, 1.2))), durationS);
    }

    /** Moves three objects in directions 120 degrees apart; all are near the centre in the middle of the film. */
    static World threeCrossing(SimulationOptions options) {
        double k = options.scale();
        Shape[] shapes = {new RegularPolygon(6, 22 * k), new Disc(19 * k), new RegularPolygon(4, 24 * k)};
        double[] ratios = {1, 1.2, 0.85};
        double[] ahead = {0, -5 * k, 5 * k};
        double[] contrasts = {0.8, 1.4, -0.8};
        double speed = speed(options, PAPER_SPEED_PX_PER_S);
        double insideS = Double.POSITIVE_INFINITY;
        for (int i = 0; i < 3; i++) {
            insideS = Math.min(insideS, insideS(options, shapes[i], 0,
                    new Heading(options.directionDeg() + 120 * i), 0, ratios[i] * speed));
        }
        double durationS = duration(options, Math.max(insideS, SHORTEST_TRAVEL_PX / 2 / speed));
        List<MovingObject> objects = new ArrayList<>();
        for (int i = 0; i < 3; i++) {
            Heading heading = new Heading(options.directionDeg() + 120 * i);
            objects.add(new MovingObject(i + 1, shapes[i],
                    through(options, heading, ahead[i], 0, ratios[i] * speed, 0, durationS),
                    dark(options, contrasts[i])));
        }
        return new World(objects, durationS);
    }

    /**
     * Moves four bars whose speed and width fall with depth. Let E be the path across the sensor and v the nearest
     * bar's speed. In units of E / v, the nearest bar overtakes the others at 0.50, 0.60 and 0.69 and leaves soon after
     * 0.9. The second bar overtakes at 0.77 and 0.89, the third at 1.07, and the film ends at 1.2. A pan that turns
     * round goes 0.9 E and comes back.
     */
    static World fourBars(SimulationOptions options) {
        double[] nearness = {1, 0.62, 0.4, 0.25};
        double[] starts = {0.1, 0.29, 0.46, 0.62};
        double[] contrasts = {1.2, 0.6, -0.6, 0.9};
        double speed = speed(options, 120);
        double across = alongS(options, new Disc(0), 1);
        double height = 4.0 * Math.max(options.sensor().width(), options.sensor().height());
        double durationS = duration(options, (options.turnsRound() ? 0.9 * Math.PI : 1.2) * across / speed);
        Heading heading = new Heading(options);
        List<MovingObject> objects = new ArrayList<>();
        for (int i = 0; i < 4; i++) {
            Shape bar = new Box(0, 0, 28 * nearness[i] * options.scale(), height);
            double v = nearness[i] * speed;
            double start = (starts[i] - 0.5) * across;
            double startX = centreX(options) + heading.x(start, 0);
            double startY = centreY(options) + heading.y(start, 0);
            Trajectory trajectory = options.turnsRound()
                    ? new ThereAndBack(startX, startY, heading.x(v, 0), heading.y(v, 0), durationS, heading.angleRad)
                    : new Straight(startX, startY, 0, heading.x(v, 0), heading.y(v, 0), heading.angleRad);
            objects.add(new MovingObject(i + 1, bar, trajectory, dark(options, contrasts[i])));
        }
        return new World(objects, durationS);
    }

    /** Hides object 1, the disc, behind the screen for (60 - 36) px of travel at the relative speed of the two. */
    static World passingBehind(SimulationOptions options) {
        double k = options.scale();
        Shape disc = new Disc(18 * k);
        Shape screen = new Box(0, 0, 60 * k, 100 * k);
        double speed = speed(options, PAPER_SPEED_PX_PER_S);
        Heading heading = new Heading(options);
        double insideS = Math.min(insideS(options, disc, 0, heading, 0, speed),
                Math.max(insideS(options, screen, heading.angleRad, heading, 0, -0.3 * speed),
                        SHORTEST_TRAVEL_PX / speed));
        double durationS = duration(options, Math.max(insideS, SHORTEST_TRAVEL_PX / 2 / speed));
        return new World(List.of(
                new MovingObject(2, screen,
                        through(options, heading, 0, 0, -0.3 * speed, heading.angleRad, durationS),
                        dark(options, 1)),
                new MovingObject(1, disc, through(options, heading, 0, 0, speed, 0, durationS),
                        dark(options, 0.6))), durationS);
    }

    static World threeWandering(SimulationOptions options) {
        return wandering(options, i -> new Capsule((36 - 4 * i) * options.scale(), (12 - i) * options.scale()));
    }

    static World wanderingDiscs(SimulationOptions options) {
        return notTurning(wandering(options, i -> new Disc((12 - i) * options.scale())));
    }

    private static World wandering(SimulationOptions options, IntFunction<Shape> shapes) {
        double[] contrasts = {1, 1.3, 0.8};
        double speed = speed(options, PAPER_SPEED_PX_PER_S);
        double durationS = duration(options, 6);
        double apart = 0.28 * Math.min(options.sensor().width(), options.sensor().height());
        Random random = new Random(options.seed());
        List<MovingObject> objects = new ArrayList<>();
        for (int i = 0; i < 3; i++) {
            Shape shape = shapes.apply(i);
            Heading heading = new Heading(options.directionDeg() + 120 * i);
            double inset = BORDER_PX + shape.radius();
            Trajectory trajectory = new Wander(
                    centreX(options) + heading.x(0, apart), centreY(options) + heading.y(0, apart),
                    heading.angleRad, centreX(options), centreY(options), Math.max(1, centreX(options) - inset),
                    Math.max(1, centreY(options) - inset), speed, durationS, new Random(random.nextLong()));
            objects.add(new MovingObject(i + 1, shape, trajectory,
                    dark(options, contrasts[i])));
        }
        return new World(objects, durationS);
    }

    /**
     * Moves four rows of four objects, neighbouring rows in opposite directions. In a row, the speeds grow by a tenth
     * from object to object, so that the leading object pulls away from those behind it. The grid fits the sensor in
     * any direction.
     */
    static World sixteen(SimulationOptions options) {
        double k = options.scale();
        Heading heading = new Heading(options);
        double halfAlong = 116;
        double halfAcross = 76;
        double cos = Math.abs(heading.x(1, 0));
        double sin = Math.abs(heading.y(1, 0));
        double fit = Math.min((centreX(options) - BORDER_PX) / (halfAlong * cos + halfAcross * sin),
                (centreY(options) - BORDER_PX) / (halfAlong * sin + halfAcross * cos));
        double radius = 10 * k * Math.min(1, fit);
        Shape[] shapes = {new RegularPolygon(6, radius), new Disc(radius), new RegularPolygon(3, radius),
            new Box(0, 0, 1.6 * radius, 1.6 * radius)};
        double[] rowRatios = {1, -0.9, 1.1, -1};
        double speed = speed(options, PAPER_SPEED_PX_PER_S);
        double durationS = duration(options, Math.min(LONGEST_S, 60 * fit / speed));
        List<MovingObject> objects = new ArrayList<>();
        for (int row = 0; row < 4; row++) {
            for (int place = 0; place < 4; place++) {
                double v = rowRatios[row] * (1 + 0.1 * place) * speed;
                double along = Math.signum(v) * (place - 1.5) * 46 * fit;
                double across = (row - 1.5) * 44 * fit;
                objects.add(new MovingObject(objects.size() + 1, shapes[(row + place) % 4],
                        through(options, heading, along, across, v, 0, durationS),
                        dark(options, place % 2 == 0 ? 1 : 1.2)));
            }
        }
        return new World(objects, durationS);
    }

    static World noise(SimulationOptions options) {
        return new World(List.of(), duration(options, NOISE_S));
    }

    /** The requested speed, or the scene's own, in px/s. */
    static double speed(SimulationOptions options, double ownPxPerS) {
        return options.speedPxPerS() == 0 ? ownPxPerS : options.speedPxPerS();
    }

    /** Random numbers that determine a scene's contents: different for each seed, even for consecutive seeds. */
    static Random random(SimulationOptions options) {
        return new Random(options.seed() * 0x9E3779B97F4A7C15L + 1);
    }

    /** The requested duration, or the scene's own, in s. */
    static double duration(SimulationOptions options, double ownS) {
        return options.durationUs() == 0 ? ownS : options.durationUs() * 1e-6;
    }

    /** Light of an object whose contrast is the option's times a factor; a negative factor makes the object bright. */
    static double dark(SimulationOptions options, double factor) {
        return StrictMath.exp(-options.contrast() * factor);
    }

    /** The direction along which a scene moves: the first of two axes, along and across, that turn with it. */
    static final class Heading {
        final double angleRad;
        private final double cos;
        private final double sin;

        Heading(SimulationOptions options) {
            this(options.directionDeg());
        }

        Heading(double deg) {
            angleRad = Math.toRadians(deg);
            cos = StrictMath.cos(angleRad);
            sin = StrictMath.sin(angleRad);
        }

        /** Distance to the right of a point that lies at distances along and across the direction. */
        double x(double along, double across) {
            return along * cos - across * sin;
        }

        double y(double along, double across) {
            return along * sin + across * cos;
        }
    }

    /**
     * A straight path that passes, in the middle of the film, the given place along and across the heading from the
     * sensor's centre.
     */
    private static Straight through(SimulationOptions options, Heading heading, double along, double across,
                                    double speedPxPerS, double angleRad, double durationS) {
        return new Straight(centreX(options) + heading.x(along, across), centreY(options) + heading.y(along, across),
                durationS / 2, heading.x(speedPxPerS, 0), heading.y(speedPxPerS, 0), angleRad);
    }

    static double centreX(SimulationOptions options) {
        return (options.sensor().width() - 1) / 2.0;
    }

    static double centreY(SimulationOptions options) {
        return (options.sensor().height() - 1) / 2.0;
    }

    /** Longest time for which an upright shape that moves through the centre stays inside the sensor, in s. */
    private static double alongS(SimulationOptions options, Shape shape, double speedPxPerS) {
        return insideS(options, shape, 0, new Heading(options), 0, speedPxPerS);
    }

    /**
     * Longest time, symmetric about its middle, for which a shape on a path stays inside the sensor, in s; 0 if it
     * never is inside.
     *
     * @param angleRad angle by which the shape is turned
     * @param across distance at which the path passes the sensor's centre, in px
     */
    private static double insideS(SimulationOptions options, Shape shape, double angleRad, Heading heading,
                                  double across, double speedPxPerS) {
        double roomX = centreX(options) - BORDER_PX - shape.reachRight(angleRad) - Math.abs(heading.x(0, across));
        double roomY = centreY(options) - BORDER_PX - shape.reachDown(angleRad) - Math.abs(heading.y(0, across));
        double vx = Math.abs(heading.x(speedPxPerS, 0));
        double vy = Math.abs(heading.y(speedPxPerS, 0));
        // A direction of 90 degrees leaves a remainder of 1e-16 of the speed along the other axis.
        double negligible = 1e-9 * Math.abs(speedPxPerS);
        double seconds = vx > negligible ? 2 * roomX / vx : Double.POSITIVE_INFINITY;
        return Math.max(0, vy > negligible ? Math.min(seconds, 2 * roomY / vy) : seconds);
    }
}
