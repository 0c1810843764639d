package io.github.sofas.flow.motion;

/** A motion straight from its equation in {@link Motion}, with the language's sine and exponential. */
public final class PlainMotion {
    private PlainMotion() {
    }

    /** A place in px. */
    public record Place(double x, double y) {
        public double distance(double toX, double toY) {
            return Math.hypot(toX - x, toY - y);
        }
    }

    /** Where what is at (x, y) at a time was or will be at the motion's reference. */
    public static Place project(Motion m, double x, double y, long timeUs) {
        double dt = (timeUs - m.referenceUs) * 1e-6;
        double turn = -(m.omega + 0.5 * m.alpha * dt) * dt;
        double scale = Math.exp(-(m.growth + 0.5 * m.growthChange * dt) * dt);
        double rx = x - m.centreX - m.vx * dt - 0.5 * m.ax * dt * dt;
        double ry = y - m.centreY - m.vy * dt - 0.5 * m.ay * dt * dt;
        return new Place(m.centreX + scale * (Math.cos(turn) * rx - Math.sin(turn) * ry),
            m.centreY + scale * (Math.sin(turn) * rx + Math.cos(turn) * ry));
    }

    /** The inverse: where what is at (x, y) at the motion's reference is at a time. */
    public static Place at(Motion m, double x, double y, long timeUs) {
        double dt = (timeUs - m.referenceUs) * 1e-6;
        double turn = (m.omega + 0.5 * m.alpha * dt) * dt;
        double scale = Math.exp((m.growth + 0.5 * m.growthChange * dt) * dt);
        double rx = x - m.centreX;
        double ry = y - m.centreY;
        return new Place(
            m.centreX + m.vx * dt + 0.5 * m.ax * dt * dt + scale * (Math.cos(turn) * rx - Math.sin(turn) * ry),
            m.centreY + m.vy * dt + 0.5 * m.ay * dt * dt + scale * (Math.sin(turn) * rx + Math.cos(turn) * ry));
    }
}
