package io.github.sofas.simulate;

/** How an object moves in the image: its place, angle and size, and the rates of the three, at any time. */
interface Trajectory {
    /** Fills the pose for a time in s since the scene began. Rates are the derivatives of place, angle and size. */
    void poseAt(double timeS, Pose pose);

    /** Greatest speed in px/s that a point at the given distance in px from the object's origin can have. */
    double maxSpeedPxPerS(double distancePx);

    /** Greatest size as a multiple of the shape's own size. */
    default double maxScale() {
        return 1;
    }

    /** Moves at constant velocity and a constant angle; the origin is at (midX, midY) at time midS. */
    record Straight(double midX, double midY, double midS, double vxPxPerS, double vyPxPerS, double angleRad)
            implements Trajectory {
        @Override
        public void poseAt(double timeS, Pose pose) {
            pose.x = midX + vxPxPerS * (timeS - midS);
            pose.y = midY + vyPxPerS * (timeS - midS);
            pose.turnTo(angleRad);
            pose.vxPxPerS = vxPxPerS;
            pose.vyPxPerS = vyPxPerS;
            pose.turnRadPerS = 0;
            pose.keepSize();
        }

        @Override
        public double maxSpeedPxPerS(double distancePx) {
            return Math.sqrt(vxPxPerS * vxPxPerS + vyPxPerS * vyPxPerS);
        }
    }

    /** Turns at a constant rate about a fixed origin. */
    record Rotation(double x, double y, double startRad, double turnRadPerS) implements Trajectory {
        @Override
        public void poseAt(double timeS, Pose pose) {
            pose.x = x;
            pose.y = y;
            pose.turnTo(startRad + turnRadPerS * timeS);
            pose.vxPxPerS = 0;
            pose.vyPxPerS = 0;
            pose.turnRadPerS = turnRadPerS;
            pose.keepSize();
        }

        @Override
        public double maxSpeedPxPerS(double distancePx) {
            return Math.abs(turnRadPerS) * distancePx;
        }
    }

    /**
     * A pan that slows down, turns round and comes back. The velocity is v cos(pi t / duration), and the place is its
     * integral.
     */
    record ThereAndBack(double startX, double startY, double vxPxPerS, double vyPxPerS, double durationS,
                        double angleRad) implements Trajectory {
        @Override
        public void poseAt(double timeS, Pose pose) {
            double phaseRad = Math.PI * timeS / durationS;
            double travelledS = durationS / Math.PI * StrictMath.sin(phaseRad);
            pose.x = startX + vxPxPerS * travelledS;
            pose.y = startY + vyPxPerS * travelledS;
            pose.turnTo(angleRad);
            double share = StrictMath.cos(phaseRad);
            pose.vxPxPerS = vxPxPerS * share;
            pose.vyPxPerS = vyPxPerS * share;
            pose.turnRadPerS = 0;
            pose.keepSize();
        }

        @Override
        public double maxSpeedPxPerS(double distancePx) {
            return Math.sqrt(vxPxPerS * vxPxPerS + vyPxPerS * vyPxPerS);
        }
    }

    /** The path of another trajectory without its turning. */
    record NotTurning(Trajectory path) implements Trajectory {
        @Override
        public void poseAt(double timeS, Pose pose) {
            path.poseAt(timeS, pose);
            pose.turnTo(0);
            pose.turnRadPerS = 0;
        }

        @Override
        public double maxSpeedPxPerS(double distancePx) {
            return path.maxSpeedPxPerS(0);
        }
    }

    /**
     * The effect of a camera's own motion on the picture of a wall: the picture slides, turns about the wall's origin
     * and grows. Each of the three rates swings about its mean by a share of that mean, a third of a period after the
     * previous rate.
     *
     * @param swing share of the mean by which a rate swings; 0 for steady motion, below 1
     */
    record Sway(double startX, double startY, double vxPxPerS, double vyPxPerS, double turnRadPerS, double growthPerS,
                double swing, double periodS) implements Trajectory {
        @Override
        public void poseAt(double timeS, Pose pose) {
            double slid = integral(timeS, 0);
            double rate = rate(timeS, 0);
            pose.x = startX + vxPxPerS * slid;
            pose.y = startY + vyPxPerS * slid;
            pose.vxPxPerS = vxPxPerS * rate;
            pose.vyPxPerS = vyPxPerS * rate;
            pose.turnTo(turnRadPerS * integral(timeS, 1));
            pose.turnRadPerS = turnRadPerS * rate(timeS, 1);
            pose.scale = StrictMath.exp(growthPerS * integral(timeS, 2));
            pose.growthPerS = growthPerS * rate(timeS, 2);
        }

        private double rate(double timeS, int third) {
            return 1 + swing * StrictMath.sin(phaseRad(timeS, third));
        }

        private double integral(double timeS, int third) {
            double swungS = periodS / (2 * Math.PI)
                * (StrictMath.cos(phaseRad(0, third)) - StrictMath.cos(phaseRad(timeS, third)));
            return timeS + swing * swungS;
        }

        private double phaseRad(double timeS, int third) {
            return 2 * Math.PI * (timeS / periodS - third / 3.0);
        }

        @Override
        public double maxSpeedPxPerS(double distancePx) {
            double speed = Math.sqrt(vxPxPerS * vxPxPerS + vyPxPerS * vyPxPerS);
            return (1 + swing) * (speed + (Math.abs(turnRadPerS) + Math.abs(growthPerS)) * distancePx);
        }
    }

    /**
     * The path of an object that is fixed to a point of a body.
     *
     * @param body the body's own path
     * @param x position of the point on the body, together with y, in px of the body's own size
     * @param angleRad angle by which the fixed object is turned against the body
     */
    record Fixed(Trajectory body, double x, double y, double angleRad) implements Trajectory {
        @Override
        public void poseAt(double timeS, Pose pose) {
            body.poseAt(timeS, pose);
            double right = pose.scale * (pose.cos * x - pose.sin * y);
            double down = pose.scale * (pose.sin * x + pose.cos * y);
            pose.x += right;
            pose.y += down;
            pose.vxPxPerS += pose.growthPerS * right - pose.turnRadPerS * down;
            pose.vyPxPerS += pose.growthPerS * down + pose.turnRadPerS * right;
            double bodyCos = pose.cos;
            double bodySin = pose.sin;
            double cos = StrictMath.cos(angleRad);
            double sin = StrictMath.sin(angleRad);
            pose.cos = bodyCos * cos - bodySin * sin;
            pose.sin = bodySin * cos + bodyCos * sin;
        }

        @Override
        public double maxSpeedPxPerS(double distancePx) {
            return body.maxSpeedPxPerS(distancePx + maxScale() * Math.sqrt(x * x + y * y));
        }

        @Override
        public double maxScale() {
            return body.maxScale();
        }
    }

    /**
     * Approaches the camera at constant speed along the line of sight of a point of the picture. The object grows away
     * from that point. Its size is 1 / (contactS - t), up to a factor: the object reaches the camera at contactS, and
     * its growth is 1 / (contactS - t).
     *
     * @param offsetX distance of the object to the right of that point when its size is 1
     * @param startScale size at time 0
     * @param endS last time at which the object is seen, before contactS
     */
    record Approach(double focusX, double focusY, double offsetX, double offsetY, double angleRad, double startScale,
                    double contactS, double endS) implements Trajectory {
        @Override
        public void poseAt(double timeS, Pose pose) {
            pose.scale = startScale * contactS / (contactS - timeS);
            pose.growthPerS = 1 / (contactS - timeS);
            pose.x = focusX + offsetX * pose.scale;
            pose.y = focusY + offsetY * pose.scale;
            pose.vxPxPerS = offsetX * pose.scale * pose.growthPerS;
            pose.vyPxPerS = offsetY * pose.scale * pose.growthPerS;
            pose.turnTo(angleRad);
            pose.turnRadPerS = 0;
        }

        @Override
        public double maxSpeedPxPerS(double distancePx) {
            double offset = maxScale() * Math.sqrt(offsetX * offsetX + offsetY * offsetY);
            return (offset + distancePx) / (contactS - endS);
        }

        @Override
        public double maxScale() {
            return startScale * contactS / (contactS - endS);
        }
    }

    /** Another trajectory backwards: at time 0 the object is where the other trajectory is at durationS. */
    record Backwards(Trajectory way, double durationS) implements Trajectory {
        @Override
        public void poseAt(double timeS, Pose pose) {
            way.poseAt(durationS - timeS, pose);
            pose.vxPxPerS = -pose.vxPxPerS;
            pose.vyPxPerS = -pose.vyPxPerS;
            pose.turnRadPerS = -pose.turnRadPerS;
            pose.growthPerS = -pose.growthPerS;
        }

        @Override
        public double maxSpeedPxPerS(double distancePx) {
            return way.maxSpeedPxPerS(distancePx);
        }

        @Override
        public double maxScale() {
            return way.maxScale();
        }
    }

    /**
     * Moves along a line and turns at a constant rate. The origin is at (atX, atY) at time atS.
     *
     * @param pace how the speed changes over time
     */
    record Journey(double atX, double atY, double atS, double vxPxPerS, double vyPxPerS, Pace pace, double startRad,
                   double turnRadPerS) implements Trajectory {
        @Override
        public void poseAt(double timeS, Pose pose) {
            double travelledS = pace.travelledS(timeS) - pace.travelledS(atS);
            double rate = pace.rate(timeS);
            pose.x = atX + vxPxPerS * travelledS;
            pose.y = atY + vyPxPerS * travelledS;
            pose.vxPxPerS = vxPxPerS * rate;
            pose.vyPxPerS = vyPxPerS * rate;
            pose.turnTo(startRad + turnRadPerS * timeS);
            pose.turnRadPerS = turnRadPerS;
            pose.keepSize();
        }

        @Override
        public double maxSpeedPxPerS(double distancePx) {
            return Math.sqrt(vxPxPerS * vxPxPerS + vyPxPerS * vyPxPerS) + Math.abs(turnRadPerS) * distancePx;
        }
    }

    /**
     * Speed over time, as a multiple of the first speed. It is 1 until changeS, and then follows half a cosine to its
     * last value within takesS.
     *
     * @param last the last value: 1 for steady motion, 0 for a stop, -1 for turning back
     */
    record Pace(double last, double changeS, double takesS) {
        double rate(double timeS) {
            double done = Math.max(0, Math.min(1, (timeS - changeS) / takesS));
            return 1 - (1 - last) * (1 - StrictMath.cos(Math.PI * done)) / 2;
        }

        /** Integral of the rate from time 0. */
        double travelledS(double timeS) {
            double since = timeS - changeS;
            if (since <= 0) {
                return timeS;
            }
            double within = Math.min(since, takesS);
            double bent = within - takesS / Math.PI * StrictMath.sin(Math.PI * within / takesS);
            return timeS - (1 - last) * (bent / 2 + Math.max(0, since - takesS));
        }
    }
}
