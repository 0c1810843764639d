package io.github.sofas.flow.track;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/**
 * Squares of dots, each of which fires whenever it comes to another pixel, for 200 ms. In the middle of that time they
 * lie side by side, about a common middle, which goes to the right, by 80 px/s unless told.
 */
final class MovingDots {
    static final long END_US = 200_000;
    static final double HALF_S = END_US * 0.5e-6;
    static final double VX = 80;
    static final double MIDDLE_X = 56;
    static final double MIDDLE_Y = 44;
    /** Of a square, in px. */
    static final double SIDE = 24;

    private final List<long[]> events = new ArrayList<>();

    /** Dots of a square, by its left side in the middle of the time, that move and turn about the common middle. */
    void move(int dots, double left, double vy, double omega) {
        move(dots, left, VX, vy, omega, 0);
    }

    /** The same with another velocity to the right, and that grow by so much a second. */
    void move(int dots, double left, double vx, double vy, double omega, double growth) {
        Random random = new Random(dots);
        for (int dot = 0; dot < dots; dot++) {
            double x0 = left + SIDE * random.nextDouble() - MIDDLE_X;
            double y0 = SIDE * (random.nextDouble() - 0.5);
            int column = Integer.MIN_VALUE;
            int row = 0;
            for (long t = 0; t < END_US; t += 50) {
                double s = t * 1e-6 - HALF_S;
                double scale = Math.exp(growth * s);
                double cos = scale * Math.cos(omega * s);
                double sin = scale * Math.sin(omega * s);
                int x = (int) Math.floor(MIDDLE_X + vx * s + cos * x0 - sin * y0);
                int y = (int) Math.floor(MIDDLE_Y + vy * s + sin * x0 + cos * y0);
                if (column != Integer.MIN_VALUE && (x != column || y != row)) {
                    events.add(new long[] {t, x, y});
                }
                column = x;
                row = y;
            }
        }
    }

    /** How many events they gave. */
    int size() {
        return events.size();
    }

    /** Adds their events to a structure's, in order of time. */
    void addTo(LiveEvents live, Claim claim) {
        inOrder().forEach(e -> live.add((int) e[1], (int) e[2], e[0], 1, claim, 0));
    }

    /** Adds their events, of a polarity, to a structure's past. */
    void addTo(TrackPlane plane, int polarity) {
        inOrder().forEach(e -> plane.addPast((int) e[1], (int) e[2], e[0], polarity, true));
    }

    private List<long[]> inOrder() {
        events.sort((a, b) -> Long.compare(a[0], b[0]));
        return events;
    }

    /** Whether a live event lies to the right of the common middle, but for the pixel that it fell on. */
    static boolean isRight(LiveEvents live, int i) {
        return live.x[i] >= MIDDLE_X + VX * (live.timeUs[i] * 1e-6 - HALF_S) - 1;
    }
}
