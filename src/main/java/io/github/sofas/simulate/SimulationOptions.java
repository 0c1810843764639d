package io.github.sofas.simulate;

import io.github.sofas.event.SensorSize;
import java.util.Objects;

/**
 * The options with which a scene is filmed: sensor, motion, sizes, light and the model of the pixels.
 *
 * @param sensor the pixel array that sees the scene
 * @param durationUs length of the film in µs; 0 for the scene's own
 * @param speedPxPerS speed of the scene's first object in px/s, to which the others keep their ratio; 0 for the scene's
 *     own. For a pendulum it is the peak speed of the bob, for a pan the speed of the nearest bar, for wanderers the
 *     typical speed, and for walls that turn or grow the speed of points a quarter of the sensor's width from the
 *     middle. Rotating bars, the flickering lamp and the random scene do not use it
 * @param directionDeg direction of the first object's motion in degrees from right to down; the whole arrangement
 *     turns with it
 * @param turnsPerS rate of the rotating bars in turns per s, negative from right to up
 * @param scale factor on the sizes of all objects, above 0
 * @param contrast logarithm of background light over the light of a plain dark object, above 0; a pixel with a
 *     threshold of 0.2 fires three times for 0.7
 * @param texture standard deviation of the background's log intensity, smooth over a few pixels; 0 for a plain
 *     background, or in a scene with textures for the scene's own value
 * @param surface the material of walls and textured objects
 * @param blurPx standard deviation of the optical blur in px, above 0
 * @param turnsRound whether a camera pan slows down, turns round and comes back
 * @param fieldOfViewM width that the sensor sees at the pendulum, in m; with 0 the swing just fills that width
 * @param seed seed of everything that is random
 * @param dvs the model of the pixels
 */
public record SimulationOptions(SensorSize sensor, long durationUs, double speedPxPerS, double directionDeg,
                                double turnsPerS, double scale, double contrast, double texture, Surface surface,
                                double blurPx, boolean turnsRound, double fieldOfViewM, long seed, DvsModel dvs) {
    /** The array of a DAVIS240C. */
    public static final SensorSize DAVIS240 = new SensorSize(240, 180);

    /** Greatest logarithm of a ratio of light: more than from starlight to the sun. */
    private static final double MOST_LOG = 20;
    private static final double MOST_SCALE = 100;
    private static final double MOST_BLUR_PX = 100;

    /**
     * Checks every component.
     *
     * @param sensor the pixel array that sees the scene
     * @param durationUs length of the film in µs; 0 for the scene's own
     * @param speedPxPerS speed of the scene's first object in px/s, to which the others keep their ratio; 0 for the
     *     scene's own. For a pendulum it is the peak speed of the bob, for a pan the speed of the nearest bar, for
     *     wanderers the typical speed, and for walls that turn or grow the speed of points a quarter of the sensor's
     *     width from the middle. Rotating bars, the flickering lamp and the random scene do not use it
     * @param directionDeg direction of the first object's motion in degrees from right to down; the whole arrangement
     *     turns with it
     * @param turnsPerS rate of the rotating bars in turns per s, negative from right to up
     * @param scale factor on the sizes of all objects, above 0
     * @param contrast logarithm of background light over the light of a plain dark object, above 0; a pixel with a
     *     threshold of 0.2 fires three times for 0.7
     * @param texture standard deviation of the background's log intensity, smooth over a few pixels; 0 for a plain
     *     background, or in a scene with textures for the scene's own value
     * @param surface the material of walls and textured objects
     * @param blurPx standard deviation of the optical blur in px, above 0
     * @param turnsRound whether a camera pan slows down, turns round and comes back
     * @param fieldOfViewM width that the sensor sees at the pendulum, in m; with 0 the swing just fills that width
     * @param seed seed of everything that is random
     * @param dvs the model of the pixels
     * @throws IllegalArgumentException if a component is out of range
     */
    public SimulationOptions {
        Objects.requireNonNull(sensor, "sensor");
        Objects.requireNonNull(surface, "surface");
        Objects.requireNonNull(dvs, "dvs");
        requireNotNegative("durationUs", durationUs);
        requireNotNegative("speedPxPerS", speedPxPerS);
        if (!Double.isFinite(directionDeg)) {
            throw new IllegalArgumentException("directionDeg must be finite but was " + directionDeg);
        }
        if (!Double.isFinite(turnsPerS) || turnsPerS == 0) {
            throw new IllegalArgumentException("turnsPerS must be finite and not 0 but was " + turnsPerS);
        }
        requireAbove("scale", scale);
        requireAbove("contrast", contrast);
        requireNotNegative("texture", texture);
        requireAbove("blurPx", blurPx);
        requireNotNegative("fieldOfViewM", fieldOfViewM);
        requireAtMost("scale", scale, MOST_SCALE);
        requireAtMost("contrast", contrast, MOST_LOG);
        requireAtMost("texture", texture, MOST_LOG);
        requireAtMost("blurPx", blurPx, MOST_BLUR_PX);
    }

    /**
     * {@return the defaults} The scene has its own duration and speed and moves to the right; rotating bars turn once
     * per second. A DAVIS240C ({@link DvsModel#davis()}) sees it with a blur of 0.7 px and a contrast of 0.7 on a plain
     * background. The seed is 1.
     */
    public static SimulationOptions defaults() {
        return new SimulationOptions(DAVIS240, 0, 0, 0, 1, 1, 0.7, 0, Surface.LEAVES, 0.7, false, 0, 1,
                DvsModel.davis());
    }

    /**
     * {@return the same with another sensor}
     *
     * @param other the new value
     */
    public SimulationOptions withSensor(SensorSize other) {
        return new SimulationOptions(other, durationUs, speedPxPerS, directionDeg, turnsPerS, scale, contrast, texture,
                surface, blurPx, turnsRound, fieldOfViewM, seed, dvs);
    }

    /**
     * {@return the same with another length of film in µs}
     *
     * @param us in µs; 0 for the scene's own
     */
    public SimulationOptions withDurationUs(long us) {
        return new SimulationOptions(sensor, us, speedPxPerS, directionDeg, turnsPerS, scale, contrast, texture,
                surface, blurPx, turnsRound, fieldOfViewM, seed, dvs);
    }

    /**
     * {@return the same with another speed in px/s}
     *
     * @param pxPerS in px/s; 0 for the scene's own
     */
    public SimulationOptions withSpeedPxPerS(double pxPerS) {
        return new SimulationOptions(sensor, durationUs, pxPerS, directionDeg, turnsPerS, scale, contrast, texture,
                surface, blurPx, turnsRound, fieldOfViewM, seed, dvs);
    }

    /**
     * {@return the same with another direction in degrees}
     *
     * @param deg from right to down
     */
    public SimulationOptions withDirectionDeg(double deg) {
        return new SimulationOptions(sensor, durationUs, speedPxPerS, deg, turnsPerS, scale, contrast, texture, surface,
                blurPx, turnsRound, fieldOfViewM, seed, dvs);
    }

    /**
     * {@return the same with another rate of turning}
     *
     * @param turns turns per second
     */
    public SimulationOptions withTurnsPerS(double turns) {
        return new SimulationOptions(sensor, durationUs, speedPxPerS, directionDeg, turns, scale, contrast, texture,
                surface, blurPx, turnsRound, fieldOfViewM, seed, dvs);
    }

    /**
     * {@return the same with objects of another size}
     *
     * @param factor on all sizes
     */
    public SimulationOptions withScale(double factor) {
        return new SimulationOptions(sensor, durationUs, speedPxPerS, directionDeg, turnsPerS, factor, contrast,
                texture, surface, blurPx, turnsRound, fieldOfViewM, seed, dvs);
    }

    /**
     * {@return the same with another contrast}
     *
     * @param logRatio logarithm of background light over an object's
     */
    public SimulationOptions withContrast(double logRatio) {
        return new SimulationOptions(sensor, durationUs, speedPxPerS, directionDeg, turnsPerS, scale, logRatio, texture,
                surface, blurPx, turnsRound, fieldOfViewM, seed, dvs);
    }

    /**
     * {@return the same with another background}
     *
     * @param sd standard deviation of log intensity
     */
    public SimulationOptions withTexture(double sd) {
        return new SimulationOptions(sensor, durationUs, speedPxPerS, directionDeg, turnsPerS, scale, contrast, sd,
                surface, blurPx, turnsRound, fieldOfViewM, seed, dvs);
    }

    /**
     * {@return the same with walls and textured objects of another material}
     *
     * @param what the new value
     */
    public SimulationOptions withSurface(Surface what) {
        return new SimulationOptions(sensor, durationUs, speedPxPerS, directionDeg, turnsPerS, scale, contrast, texture,
                what, blurPx, turnsRound, fieldOfViewM, seed, dvs);
    }

    /**
     * {@return the same with another blur in px}
     *
     * @param px standard deviation in px
     */
    public SimulationOptions withBlurPx(double px) {
        return new SimulationOptions(sensor, durationUs, speedPxPerS, directionDeg, turnsPerS, scale, contrast, texture,
                surface, px, turnsRound, fieldOfViewM, seed, dvs);
    }

    /**
     * {@return the same with a pan that turns round, or not}
     *
     * @param round whether the pan turns round
     */
    public SimulationOptions withTurnsRound(boolean round) {
        return new SimulationOptions(sensor, durationUs, speedPxPerS, directionDeg, turnsPerS, scale, contrast, texture,
                surface, blurPx, round, fieldOfViewM, seed, dvs);
    }

    /**
     * {@return the same with another field of view in m}
     *
     * @param m in m; with 0 the swing fills the field of view
     */
    public SimulationOptions withFieldOfViewM(double m) {
        return new SimulationOptions(sensor, durationUs, speedPxPerS, directionDeg, turnsPerS, scale, contrast, texture,
                surface, blurPx, turnsRound, m, seed, dvs);
    }

    /**
     * {@return the same with another seed}
     *
     * @param other the new value
     */
    public SimulationOptions withSeed(long other) {
        return new SimulationOptions(sensor, durationUs, speedPxPerS, directionDeg, turnsPerS, scale, contrast, texture,
                surface, blurPx, turnsRound, fieldOfViewM, other, dvs);
    }

    /**
     * {@return the same with another model of the pixels}
     *
     * @param model of the pixels
     */
    public SimulationOptions withDvs(DvsModel model) {
        return new SimulationOptions(sensor, durationUs, speedPxPerS, directionDeg, turnsPerS, scale, contrast, texture,
                surface, blurPx, turnsRound, fieldOfViewM, seed, model);
    }

    private static void requireAtMost(String name, double value, double most) {
        if (value > most) {
            throw new IllegalArgumentException(name + " must be at most " + most + " but was " + value);
        }
    }

    private static void requireAbove(String name, double value) {
        if (!(value > 0) || Double.isInfinite(value)) {
            throw new IllegalArgumentException(name + " must be positive but was " + value);
        }
    }

    private static void requireNotNegative(String name, double value) {
        if (!(value >= 0) || Double.isInfinite(value)) {
            throw new IllegalArgumentException(name + " must not be negative but was " + value);
        }
    }
}
