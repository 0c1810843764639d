package io.github.sofas.simulate;

/**
 * A wall before a camera that turns, or that slides past a wall seen at a slant. The speed of the picture where the
 * lens looks swings about its mean.
 *
 * @param focalPx focal length of the lens in px
 * @param middleX point of the sensor that the lens looks at, in px
 * @param headingX direction in which the picture moves there, of length 1
 * @param speedPxPerS its mean speed there
 * @param turns whether the camera turns; else it slides
 * @param slantX how far the wall goes back for each px to the right; 0 of one that is seen from the front
 * @param swing share of the speed that it swings by
 * @param periodS of the swing, in the middle of which the camera has neither turned nor slid
 */
record CameraPath(double focalPx, double middleX, double middleY, double headingX, double headingY,
                  double speedPxPerS, boolean turns, double slantX, double slantY, double swing,
                  double periodS) implements Trajectory {
    /** Half the time over which the change of the map is taken. */
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

    /** Angle that the picture has gone on by since the middle of the time, in rad where the camera looks. */
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
            // the ray through (1, 0), (0, 1) and the corner of the sensor, in focal lengths
            double u = (axis == 0 ? 1 : axis == 1 ? 0 : -middleX) / focalPx;
            double v = (axis == 1 ? 1 : axis == 0 ? 0 : -middleY) / focalPx;
            double ahead = axis == 2 ? 1 : 0;
            // turned in the plane of the heading and the line of sight
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
