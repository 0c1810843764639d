package io.github.sofas.flow.motion;

/**
 * How the flow of a plane departs from that of a structure that only turns and grows about its centre. A plane seen at
 * a slant also moves faster on one side. Before a camera that turns, the border of the picture moves faster than its
 * middle: by a third with a lens of 60 degrees. The flow of any plane is the sum of velocity, rotation, growth and
 * deformation (Longuet-Higgins and Prazdny, The interpretation of a moving retinal image, 1980). Ours beyond the paper,
 * which has velocities only.
 *
 * <p>Deformation adds S r + (perspective . r) r to the velocity of a point at r from the centre. The matrix S stretches
 * along one axis and squeezes along the other.
 */
public final class Deformation {
    /** Stretch along the x axis, and squeeze along the y axis, in 1/s. */
    public double stretch;
    /** Stretch along the diagonal on which x and y grow alike, and squeeze along the other diagonal, in 1/s. */
    public double shear;
    /** Coefficients of the part that grows with the square of the distance from the centre, in 1/(px s). */
    public double perspectiveX;
    public double perspectiveY;

    /** Resets to no deformation. */
    public void clear() {
        stretch = 0;
        shear = 0;
        perspectiveX = 0;
        perspectiveY = 0;
    }

    /** Copies another deformation. */
    public void copyFrom(Deformation other) {
        stretch = other.stretch;
        shear = other.shear;
        perspectiveX = other.perspectiveX;
        perspectiveY = other.perspectiveY;
    }

    /** Multiplies all components by a factor. */
    public void multiply(double by) {
        stretch *= by;
        shear *= by;
        perspectiveX *= by;
        perspectiveY *= by;
    }

    /** Adds another deformation, multiplied by a weight. */
    public void add(Deformation other, double weight) {
        stretch += weight * other.stretch;
        shear += weight * other.shear;
        perspectiveX += weight * other.perspectiveX;
        perspectiveY += weight * other.perspectiveY;
    }

    /** Whether there is no deformation. */
    public boolean isNone() {
        return stretch == 0 && shear == 0 && perspectiveX == 0 && perspectiveY == 0;
    }

    /** Velocity to the right, in px/s, that deformation adds at a point so many px from the centre. */
    public double vx(double rx, double ry) {
        return stretch * rx + shear * ry + perspective(rx, ry) * rx;
    }

    /** Velocity downwards, likewise. */
    public double vy(double rx, double ry) {
        return shear * rx - stretch * ry + perspective(rx, ry) * ry;
    }

    /** Growth, in 1/s, that perspective adds about a point so many px from the centre. */
    public double growthAt(double rx, double ry) {
        return 1.5 * perspective(rx, ry);
    }

    /** Rotation, in rad/s, that perspective adds there. */
    public double omegaAt(double rx, double ry) {
        return (perspectiveX * ry - perspectiveY * rx) / 2;
    }

    /** Square of the speed that stretch and shear give a point 1 px from the centre, in 1/s². */
    double square() {
        return stretch * stretch + shear * shear;
    }

    /** Moves the centre by so many px: stretch and shear change with the point about which they are taken. */
    void moveCentre(double rx, double ry) {
        stretch += (perspectiveX * rx - perspectiveY * ry) / 2;
        shear += (perspectiveX * ry + perspectiveY * rx) / 2;
    }

    /** Upper bound, in px/s, of the speed that deformation adds at any point within a distance of the centre. */
    double mostSpeed(double distance) {
        double perspective = Math.sqrt(perspectiveX * perspectiveX + perspectiveY * perspectiveY);
        return (Math.sqrt(square()) + perspective * distance) * distance;
    }

    private double perspective(double rx, double ry) {
        return perspectiveX * rx + perspectiveY * ry;
    }
}
