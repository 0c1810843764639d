package io.github.sofas.flow.motion;

/**
 * How the flow of a plane departs from that of what only turns and grows about its centre: what is seen at a slant
 * also moves faster on one side, and before a camera that turns the border of the picture moves faster than its
 * middle, by a third with a lens of 60 degrees. The flow of any plane is a velocity, rotation, growth and this
 * (Longuet-Higgins and Prazdny, The interpretation of a moving retinal image, 1980). Ours beyond the paper, which has
 * velocities only.
 *
 * <p>To the velocity of a point at r from the centre it adds S r + (perspective . r) r, where S stretches along one
 * axis and squeezes along the other.
 */
public final class Deformation {
    /** Stretch along the x axis, and squeeze along the y axis, in 1/s. */
    public double stretch;
    /** Stretch along the diagonal where x and y grow alike, and squeeze along the other, in 1/s. */
    public double shear;
    /** What the square of the distance adds, in 1/(px s). */
    public double perspectiveX;
    public double perspectiveY;

    /** Becomes none. */
    public void clear() {
        stretch = 0;
        shear = 0;
        perspectiveX = 0;
        perspectiveY = 0;
    }

    /** Becomes the same as another. */
    public void copyFrom(Deformation other) {
        stretch = other.stretch;
        shear = other.shear;
        perspectiveX = other.perspectiveX;
        perspectiveY = other.perspectiveY;
    }

    /** Multiplies all of it. */
    public void multiply(double by) {
        stretch *= by;
        shear *= by;
        perspectiveX *= by;
        perspectiveY *= by;
    }

    /** Adds another as often as its weight says. */
    public void add(Deformation other, double weight) {
        stretch += weight * other.stretch;
        shear += weight * other.shear;
        perspectiveX += weight * other.perspectiveX;
        perspectiveY += weight * other.perspectiveY;
    }

    /** Whether there is none. */
    public boolean isNone() {
        return stretch == 0 && shear == 0 && perspectiveX == 0 && perspectiveY == 0;
    }

    /** Velocity to the right, in px/s, that it gives a point so many px from the centre. */
    public double vx(double rx, double ry) {
        return stretch * rx + shear * ry + perspective(rx, ry) * rx;
    }

    /** The same downwards. */
    public double vy(double rx, double ry) {
        return shear * rx - stretch * ry + perspective(rx, ry) * ry;
    }

    /** Growth in 1/s that perspective adds to what has its centre so many px from this one's. */
    public double growthAt(double rx, double ry) {
        return 1.5 * perspective(rx, ry);
    }

    /** The same of rotation, in rad/s. */
    public double omegaAt(double rx, double ry) {
        return (perspectiveX * ry - perspectiveY * rx) / 2;
    }

    /** Square of the speed that stretch and shear give a point 1 px from the centre, in 1/s². */
    double square() {
        return stretch * stretch + shear * shear;
    }

    /** Moves the centre, about which stretch and shear are other ones. */
    void moveCentre(double rx, double ry) {
        stretch += (perspectiveX * rx - perspectiveY * ry) / 2;
        shear += (perspectiveX * ry + perspectiveY * rx) / 2;
    }

    /** A speed in px/s that it gives no point within a distance more than. */
    double mostSpeed(double distance) {
        double perspective = Math.sqrt(perspectiveX * perspectiveX + perspectiveY * perspectiveY);
        return (Math.sqrt(square()) + perspective * distance) * distance;
    }

    private double perspective(double rx, double ry) {
        return perspectiveX * rx + perspectiveY * ry;
    }
}
