package io.github.sofas.flow.motion;

/**
 * The matrix by which rotation, growth, stretch and shear change, within a time, the offset in px of a point from the
 * centre of a motion. Perspective is left out, because no matrix describes it.
 *
 * <p>{@link #takeFirstOrder} sets the change of the offset, {@link #take} the whole offset after the time.
 */
public final class Gradient {
    /** Px to the right (xx) and downwards (yx) for each px of offset to the right. */
    public double xx;
    public double yx;
    /** Px to the right (xy) and downwards (yy) for each px of offset downwards. */
    public double xy;
    public double yy;

    /** Sets what is added to an offset within a short time, in s: the flow, times that time. */
    public void takeFirstOrder(Motion motion, double seconds) {
        xx = (motion.growth + motion.deformation.stretch) * seconds;
        xy = (motion.deformation.shear - motion.omega) * seconds;
        yx = (motion.deformation.shear + motion.omega) * seconds;
        yy = (motion.growth - motion.deformation.stretch) * seconds;
    }

    /** Sets what an offset becomes after a time, in s, exactly: the exponential of the flow. */
    public void take(Motion motion, double seconds) {
        double stretch = motion.deformation.stretch;
        double shear = motion.deformation.shear;
        // without growth, the square of the flow matrix is this number times the unit matrix
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

    /** X component, in px, of the matrix times an offset from the centre. */
    public double x(double rx, double ry) {
        return xx * rx + xy * ry;
    }

    /** Y component, likewise. */
    public double y(double rx, double ry) {
        return yx * rx + yy * ry;
    }
}
