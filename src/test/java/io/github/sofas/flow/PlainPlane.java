package io.github.sofas.flow;

import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Projection onto a plane without borders, straight from the paper's definitions, for tests to compare with. */
public final class PlainPlane {
    private PlainPlane() {
    }

    /** An event on the sensor. */
    public record Event(int x, int y, long timeUs, int polarity) {
    }

    /** A cell of a projected plane. The methods that a record generates are slow where code is compiled quickly. */
    public record Cell(long x, long y) {
        @Override
        public boolean equals(Object other) {
            return other instanceof Cell cell && cell.x == x && cell.y == y;
        }

        @Override
        public int hashCode() {
            return 31 * Long.hashCode(x) + Long.hashCode(y);
        }
    }

    /** A projection: (u - vx (t - t0), v - vy (t - t0)), to the nearest cell. */
    public record Plane(double vxPxPerS, double vyPxPerS, long referenceUs) {
        public Cell cellOf(Event e) {
            long dt = e.timeUs - referenceUs;
            return new Cell(e.x - shift(vxPxPerS, dt), e.y - shift(vyPxPerS, dt));
        }
    }

    /** Pixels travelled, rounded to the nearest, of a velocity that is a multiple of 2^-28 px/us. */
    private static long shift(double pxPerS, long dt) {
        long velocity = Math.round(pxPerS / 1e6 * 0x1p28);
        return Math.floorDiv(Math.addExact(Math.multiplyExact(velocity, dt), 1L << 27), 1L << 28);
    }

    /** f(x, y): the sum of the signs of the events that fall on each cell. */
    public static Map<Cell, Integer> accumulate(List<Event> events, Plane plane) {
        Map<Cell, Integer> f = new HashMap<>(2 * events.size());
        for (Event e : events) {
            f.merge(plane.cellOf(e), e.polarity, Integer::sum);
        }
        return f;
    }

    /** m = sum of f squared. */
    public static long metric(List<Event> events, Plane plane) {
        long m = 0;
        for (int f : accumulate(events, plane).values()) {
            m += (long) f * f;
        }
        return m;
    }

    /** The angle of projection i of n over a range around a centre, in degrees. */
    public static double angle(double centreDeg, int i, int n, double rangeDeg) {
        return limited(centreDeg + (i - (n - 1) / 2.0) * rangeDeg / n);
    }

    /** An angle short of the right one, where velocity is infinite. */
    public static double limited(double angleDeg) {
        return Math.max(-89, Math.min(89, angleDeg));
    }

    /** Velocity of a projection at an angle. */
    public static double velocity(double scalePxPerS, double angleDeg) {
        return scalePxPerS * Math.tan(Math.toRadians(angleDeg));
    }
}
