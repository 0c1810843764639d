package io.github.sofas.simulate;

/**
 * The outline of an object in its own axes, as a signed distance.
 *
 * <p>A shape is at rest and has no grey level and no texture. A {@link Trajectory} places it, and a
 * {@link MovingObject} paints it.
 */
interface Shape {
    /**
     * Distance from a point to the outline in px, negative inside. The magnitude never exceeds the true distance.
     */
    double signedDistance(double x, double y);

    /** Radius of a circle around the origin that contains the shape, in px. */
    double radius();

    /** Greatest reach to the right or left of the shape turned by the angle, which is half of its width. */
    double reachRight(double angleRad);

    /** Greatest reach up or down of the shape turned by the angle. */
    default double reachDown(double angleRad) {
        return reachRight(angleRad - Math.PI / 2);
    }

    /** The whole plane, for a wall behind all other objects. */
    record Everywhere() implements Shape {
        @Override
        public double signedDistance(double x, double y) {
            return Double.NEGATIVE_INFINITY;
        }

        @Override
        public double radius() {
            return Double.POSITIVE_INFINITY;
        }

        @Override
        public double reachRight(double angleRad) {
            return Double.POSITIVE_INFINITY;
        }
    }

    /** A disc around the origin. */
    record Disc(double radius) implements Shape {
        @Override
        public double signedDistance(double x, double y) {
            return Math.sqrt(x * x + y * y) - radius;
        }

        @Override
        public double reachRight(double angleRad) {
            return radius;
        }
    }

    /** A rectangle with sides along the axes. */
    record Box(double centreX, double centreY, double width, double height) implements Shape {
        @Override
        public double signedDistance(double x, double y) {
            double outX = Math.abs(x - centreX) - width / 2;
            double outY = Math.abs(y - centreY) - height / 2;
            if (outX > 0 && outY > 0) {
                return Math.sqrt(outX * outX + outY * outY);
            }
            return Math.max(outX, outY);
        }

        @Override
        public double radius() {
            double farX = Math.abs(centreX) + width / 2;
            double farY = Math.abs(centreY) + height / 2;
            return Math.sqrt(farX * farX + farY * farY);
        }

        @Override
        public double reachRight(double angleRad) {
            double cos = StrictMath.cos(angleRad);
            double sin = StrictMath.sin(angleRad);
            return Math.abs(centreX * cos - centreY * sin) + (width * Math.abs(cos) + height * Math.abs(sin)) / 2;
        }
    }

    /** A body with round ends along the x axis: all points within a radius of a line segment through the origin. */
    record Capsule(double length, double width) implements Shape {
        @Override
        public double signedDistance(double x, double y) {
            double halfLine = (length - width) / 2;
            double beyond = Math.max(0, Math.abs(x) - halfLine);
            return Math.sqrt(beyond * beyond + y * y) - width / 2;
        }

        @Override
        public double radius() {
            return length / 2;
        }

        @Override
        public double reachRight(double angleRad) {
            return (length - width) / 2 * Math.abs(StrictMath.cos(angleRad)) + width / 2;
        }
    }

    /**
     * A regular polygon around the origin, its first corner on the x axis.
     *
     * <p>The distance is computed in one sector: the point is turned into the sector of the nearest side, where that
     * side is upright at the inner radius.
     */
    final class RegularPolygon implements Shape {
        private final int corners;
        private final double radius;
        private final double innerRadius;
        private final double halfSide;
        private final double[] normalX;
        private final double[] normalY;

        RegularPolygon(int corners, double radius) {
            this.corners = corners;
            this.radius = radius;
            innerRadius = radius * StrictMath.cos(Math.PI / corners);
            halfSide = radius * StrictMath.sin(Math.PI / corners);
            normalX = new double[corners];
            normalY = new double[corners];
            for (int i = 0; i < corners; i++) {
                double angleRad = (2 * i + 1) * Math.PI / corners;
                normalX[i] = StrictMath.cos(angleRad);
                normalY[i] = StrictMath.sin(angleRad);
            }
        }

        @Override
        public double signedDistance(double x, double y) {
            double out = Double.NEGATIVE_INFINITY;
            double along = 0;
            for (int i = 0; i < corners; i++) {
                double far = x * normalX[i] + y * normalY[i];
                if (far > out) {
                    out = far;
                    along = Math.abs(y * normalX[i] - x * normalY[i]);
                }
            }
            out -= innerRadius;
            double beyond = along - halfSide;
            return out > 0 && beyond > 0 ? Math.sqrt(out * out + beyond * beyond) : out;
        }

        @Override
        public double radius() {
            return radius;
        }

        @Override
        public double reachRight(double angleRad) {
            double reach = 0;
            for (int i = 0; i < corners; i++) {
                reach = Math.max(reach, Math.abs(radius * StrictMath.cos(angleRad + 2 * i * Math.PI / corners)));
            }
            return reach;
        }
    }

    /** Several shapes as one. */
    final class Union implements Shape {
        private final Shape[] parts;

        Union(Shape... parts) {
            this.parts = parts;
        }

        @Override
        public double signedDistance(double x, double y) {
            double nearest = Double.POSITIVE_INFINITY;
            for (Shape part : parts) {
                nearest = Math.min(nearest, part.signedDistance(x, y));
            }
            return nearest;
        }

        @Override
        public double radius() {
            double radius = 0;
            for (Shape part : parts) {
                radius = Math.max(radius, part.radius());
            }
            return radius;
        }

        @Override
        public double reachRight(double angleRad) {
            double reach = 0;
            for (Shape part : parts) {
                reach = Math.max(reach, part.reachRight(angleRad));
            }
            return reach;
        }
    }
}
