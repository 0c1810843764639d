package io.github.sofas.simulate;

/**
 * An opaque object of a scene: an outline, painted and moved along a path. The object is rigid except for its size.
 *
 * @param id the object's number in the truth, from 1; the pieces of one body have the same number
 * @param shape its outline
 * @param trajectory its path
 * @param light its brightness as a multiple of the background's, above 0
 * @param texture the texture of its surface; null if it is evenly grey
 */
record MovingObject(int id, Shape shape, Trajectory trajectory, double light, Texture texture) {
    /** An evenly grey object. */
    MovingObject(int id, Shape shape, Trajectory trajectory, double light) {
        this(id, shape, trajectory, light, null);
    }

    /** Light of the object's surface at a pixel of the sensor, for a pose of the object. */
    double lightAt(Pose pose, double x, double y) {
        return texture == null ? light
            : light * StrictMath.exp(texture.logLightAt(pose.alongX(x, y), pose.alongY(x, y)));
    }
}
