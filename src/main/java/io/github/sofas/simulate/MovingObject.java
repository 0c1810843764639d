package io.github.sofas.simulate;

/**
 * An opaque object, rigid but for its size.
 *
 * @param id what the truth calls it, from 1; the pieces of one body have the same
 * @param shape its outline
 * @param trajectory its path
 * @param light its brightness as a multiple of the background's, above 0
 * @param texture what it is painted with; null where it is evenly grey
 */
record MovingObject(int id, Shape shape, Trajectory trajectory, double light, Texture texture) {
    /** An evenly grey object. */
    MovingObject(int id, Shape shape, Trajectory trajectory, double light) {
        this(id, shape, trajectory, light, null);
    }

    /** Light of its surface at a pixel of the sensor, when it is in a pose. */
    double lightAt(Pose pose, double x, double y) {
        return texture == null ? light
            : light * StrictMath.exp(texture.logLightAt(pose.alongX(x, y), pose.alongY(x, y)));
    }
}
