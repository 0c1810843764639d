package io.github.sofas.flow.motion;

/**
 * What rotation, growth, stretch and shear make in a time of the px between a point and the centre of a motion: a
 * matrix. Perspective, which no matrix is, is left out.
 */
public final class Gradient {
    /** Px to the right, then downwards, by a px to the right. */
    public double xx;
    public double yx;
    /** The same by a px downwards. */
    public double xy;
    public double yy;

    /** Becomes what is added in a short time, in s: the flow itself. */
    public void takeFirstOrder(Motion motion, double seconds) {
        xx = (motion.growth + motion.deformation.stretch) * seconds;
        xy = (motion.deformation.shear - motion.omega) * seconds;
        yx = (motion.deformation.shear + motion.omega) * seconds;
        yy = (motion.growth - motion.deformation.stretch) * seconds;
    }

    /** Becomes what they are after a time, in s, exactly: the exponential of the flow. */
    public void take(Motion motion, double seconds) {
        double stretch = motion.deformation.stretch;
        double shear = motion.deformation.shear;
        // without growth, the square of the flow is this times one
        double square = stretch * stretch + shear * shear - motion.omega * motion.omega;
        double root = StrictMath.sqrt(Math.abs(square));
        double even = square < 0 ? StrictMath.cos(root * seconds) : StrictMath.cosh(root * seconds);
        double odd = square < 0 ? StrictMath.sin(root * seconds) / root
            : square > 0 ? StrictMath.sinh(root * seconds) / root : seconds;
        double scale = StrictMath.exp(motion.growth * seconds);
        xx = scale * (even + odd * stretch);
        xy = scale * odd * (shear - motion.omega);
        yx = scale * odd * (shear + motion.omega);
        yy = scale * (even - odd * stretch);
    }

    /** Column of what lies so many px from the centre. */
    public double x(double rx, double ry) {
        return xx * rx + xy * ry;
    }

    /** The same, the row. */
    public double y(double rx, double ry) {
        return yx * rx + yy * ry;
    }
}
