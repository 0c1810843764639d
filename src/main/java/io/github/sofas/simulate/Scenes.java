package io.github.sofas.simulate;

import io.github.sofas.simulate.Motion.Straight;
import io.github.sofas.simulate.Shape.Box;
import io.github.sofas.simulate.Shape.Disc;
import io.github.sofas.simulate.Shape.RegularPolygon;
import io.github.sofas.simulate.Shape.Union;
import java.util.List;

/** Arranges the objects of each scene for a sensor of any size. */
final class Scenes {
    /** The paper's speed for its four shapes, in px/s. */
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
     * One object through the sensor's centre, inside the sensor from first to last: the whole path, but no more than
     * five seconds or, where it is slow, 120 px. A shape too large to travel its own width's quarter inside comes in
     * and leaves: its centre crosses the sensor.
     */
    private static World oneShape(SimulationOptions options, Shape shape) {
        double speed = speed(options, PAPER_SPEED_PX_PER_S);
        double vx = speed * cos(options.directionDeg());
        double vy = speed * sin(options.directionDeg());
        double insideS = insideS(options, shape, 0, 0, 0, vx, vy);
        if (insideS * speed < shape.radius() / 2) {
            insideS = insideS(options, new Disc(0), 0, 0, 0, vx, vy);
        }
        double durationS = duration(options, Math.min(insideS, Math.max(LONGEST_S, SHORTEST_TRAVEL_PX / speed)));
        return new World(List.of(new MovingObject(1, shape,
                through(options, 0, 0, vx, vy, 0, durationS), dark(options, 1))), durationS);
    }

    static World twoOpposite(SimulationOptions options) {
        double k = options.scale();
        Shape hexagon = new RegularPolygon(6, 24 * k);
        Shape disc = new Disc(22 * k);
        double aside = Math.max(0.23 * Math.min(options.sensor().width(), options.sensor().height()), 27 * k);
        double speed = speed(options, PAPER_SPEED_PX_PER_S);
        double cos = cos(options.directionDeg());
        double sin = sin(options.directionDeg());
        double back = -1.25 * speed;
        double insideS = Math.min(
                insideS(options, hexagon, 0, sin * aside, -cos * aside, speed * cos, speed * sin),
                insideS(options, disc, 0, -sin * aside, cos * aside, back * cos, back * sin));
        double durationS = duration(options, Math.max(insideS, SHORTEST_TRAVEL_PX / 2 / speed));
        return new World(List.of(
                new MovingObject(1, hexagon,
                        through(options, sin * aside, -cos * aside, speed * cos, speed * sin, 0, durationS),
                        dark(options, 1)),
                new MovingObject(2, disc,
                        through(options, -sin * aside, cos * aside, back * cos, back * sin, 0, durationS),
                        dark(options, 1.2))), durationS);
    }

    static World noise(SimulationOptions options) {
        return new World(List.of(), duration(options, NOISE_S));
    }

    private static double speed(SimulationOptions options, double ownPxPerS) {
        return options.speedPxPerS() == 0 ? ownPxPerS : options.speedPxPerS();
    }

    private static double duration(SimulationOptions options, double ownS) {
        return options.durationUs() == 0 ? ownS : options.durationUs() * 1e-6;
    }

    /** Light of an object whose contrast to the background is the option's times a factor; negative for a bright one. */
    private static double dark(SimulationOptions options, double factor) {
        return StrictMath.exp(-options.contrast() * factor);
    }

    private static double cos(double deg) {
        return StrictMath.cos(Math.toRadians(deg));
    }

    private static double sin(double deg) {
        return StrictMath.sin(Math.toRadians(deg));
    }

    /** A straight path that is, in the middle of the film, at the given place from the sensor's centre. */
    private static Straight through(SimulationOptions options, double fromCentreX, double fromCentreY, double vx,
                                    double vy, double angleRad, double durationS) {
        return new Straight(centreX(options) + fromCentreX, centreY(options) + fromCentreY, durationS / 2, vx, vy,
                angleRad);
    }

    private static double centreX(SimulationOptions options) {
        return (options.sensor().width() - 1) / 2.0;
    }

    private static double centreY(SimulationOptions options) {
        return (options.sensor().height() - 1) / 2.0;
    }

    /** The longest time, symmetric about its middle, that the path stays inside the sensor; 0 where it is never. */
    private static double insideS(SimulationOptions options, Shape shape, double angleRad, double fromCentreX,
                                  double fromCentreY, double vx, double vy) {
        double roomX = centreX(options) - BORDER_PX - shape.reachRight(angleRad) - Math.abs(fromCentreX);
        double roomY = centreY(options) - BORDER_PX - shape.reachDown(angleRad) - Math.abs(fromCentreY);
        double seconds = Double.POSITIVE_INFINITY;
        // A direction of 90 degrees has a rest of 1e-15 of its speed along the other axis.
        if (Math.abs(vx) > 1e-9) {
            seconds = 2 * roomX / Math.abs(vx);
        }
        if (Math.abs(vy) > 1e-9) {
            seconds = Math.min(seconds, 2 * roomY / Math.abs(vy));
        }
        return Math.max(0, seconds);
    }
}
