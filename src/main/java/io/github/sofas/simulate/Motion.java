package io.github.sofas.simulate;

/** How a rigid object moves in the image: its place, angle, velocity and rate of turning at any time. */
interface Motion {
    /** Fills the pose for a time in s since the scene began; velocities are the derivatives of place and angle. */
    void poseAt(double timeS, Pose pose);

    /** The greatest speed in px/s that a point at a distance in px from the object's origin can have. */
    double maxSpeedPxPerS(double distancePx);

    /** Constant velocity at a constant angle; the origin is at (midX, midY) at time midS. */
    record Straight(double midX, double midY, double midS, double vxPxPerS, double vyPxPerS, double angleRad)
            implements Motion {
        @Override
        public void poseAt(double timeS, Pose pose) {
            pose.x = midX + vxPxPerS * (timeS - midS);
            pose.y = midY + vyPxPerS * (timeS - midS);
            pose.turnTo(angleRad);
            pose.vxPxPerS = vxPxPerS;
            pose.vyPxPerS = vyPxPerS;
            pose.turnRadPerS = 0;
        }

        @Override
        public double maxSpeedPxPerS(double distancePx) {
            return Math.sqrt(vxPxPerS * vxPxPerS + vyPxPerS * vyPxPerS);
        }
    }

    /** Turning at a constant rate about a fixed origin. */
    record Rotation(double x, double y, double startRad, double turnRadPerS) implements Motion {
        @Override
        public void poseAt(double timeS, Pose pose) {
            pose.x = x;
            pose.y = y;
            pose.turnTo(startRad + turnRadPerS * timeS);
            pose.vxPxPerS = 0;
            pose.vyPxPerS = 0;
            pose.turnRadPerS = turnRadPerS;
        }

        @Override
        public double maxSpeedPxPerS(double distancePx) {
            return Math.abs(turnRadPerS) * distancePx;
        }
    }

    /**
     * A pan that slows down, turns round and comes back: velocity v cos(pi t / duration), place its integral.
     */
    record ThereAndBack(double startX, double startY, double vxPxPerS, double vyPxPerS, double durationS,
                        double angleRad) implements Motion {
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
        }

        @Override
        public double maxSpeedPxPerS(double distancePx) {
            return Math.sqrt(vxPxPerS * vxPxPerS + vyPxPerS * vyPxPerS);
        }
    }
}
