package io.github.sofas.simulate;

/**
 * The path of a wall before a camera that either turns, or slides past the wall and sees it at a slant. The path is a
 * projective map that changes over time. The speed of the picture at the point that the lens looks at swings about its
 * mean.
 *
 * @param focalPx focal length of the lens in px
 * @param middleX column of the sensor that the lens looks at, in px
 * @param headingX direction in which the picture moves there, as a vector of length 1
 * @param speedPxPerS mean speed of the picture there
 * @param turns whether the camera turns; otherwise it slides
 * @param slantX how far the wall recedes per px to the right; 0 for a wall seen from the front
 * @param swing share of the speed by which the speed swings
 * @param periodS period of the swing; in its middle, the camera has neither turned nor slid
 */
record CameraPath(double focalPx, double middleX, double middleY, double headingX, double headingY,
                  double speedPxPerS, boolean turns, double slantX, double slantY, double swing,
                  double periodS) implements Trajectory {
    /** Half the time over which the rate of the map is measured, in s. */
    private static final double STEP_S = 1e-4;

    @Override
    public void poseAt(double timeS, Pose pose) {
        WallView view = pose.view();
        double[] map = view.map();
        double[] rate = view.rate();
        fill(timeS - STEP_S, rate);
        fill(timeS + STEP_S, map);
        for (int k = 0; k < map.length; k++) {
            rate[k] = (map[k] - rate[k]) / (2 * STEP_S);
        }
        fill(timeS, map);
    }

    /** Angle by which the picture has moved since the middle of the period, in rad at the point the camera looks at. */
    private double travelled(double timeS) {
        double sinceS = timeS - periodS / 2;
        double phase = 2 * Math.PI / periodS;
        return speedPxPerS / focalPx * (sinceS + swing * StrictMath.sin(phase * sinceS) / phase);
    }

    private void fill(double timeS, double[] map) {
        double angle = travelled(timeS);
        double cos = turns ? StrictMath.cos(angle) : 1;
        double sin = turns ? StrictMath.sin(angle) : 0;
        double fromX = turns ? 0 : -angle * headingX;
        double fromY = turns ? 0 : -angle * headingY;
        double depth = 1 + slantX * fromX + slantY * fromY;
        for (int axis = 0; axis < 3; axis++) {
            // one axis at a time: the ray through (1, 0), (0, 1) and the corner of the sensor, in focal lengths
            double u = (axis == 0 ? 1 : axis == 1 ? 0 : -middleX) / focalPx;
            double v = (axis == 1 ? 1 : axis == 0 ? 0 : -middleY) / focalPx;
            double ahead = axis == 2 ? 1 : 0;
            // turn the ray in the plane of the heading and the line of sight
            double along = u * headingX + v * headingY;
            double turned = cos * along - sin * ahead;
            double x = u + (turned - along) * headingX;
            double y = v + (turned - along) * headingY;
            double z = sin * along + cos * ahead - slantX * x - slantY * y;
            map[axis] = focalPx * (fromX * z + depth * x);
            map[3 + axis] = focalPx * (fromY * z + depth * y);
            map[6 + axis] = z;
        }
    }

    @Override
    public double maxSpeedPxPerS(double radiusPx) {
        throw new UnsupportedOperationException("a wall has no radius");
    }
}
