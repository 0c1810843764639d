package io.github.sofas.evaluate;

import io.github.sofas.event.SensorSize;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;

/**
 * Searches for the one velocity that makes the picture of all events of a window sharpest. This is the best that a
 * method can achieve if it does not know segments, but has seen the whole window.
 *
 * <p>The coarse search covers all travels over the window of up to half the sensor's longer side. It takes a grid of at
 * most {@value #STEPS} steps to each side, with cells as large as a step, and the variance of the counts of at most
 * {@value #COARSE_EVENTS} events. The best peaks are refined while steps and cells are halved. The fine search starts
 * from the best refined peaks, the velocity of the previous window, and rest. It climbs on the variance of the picture
 * itself, in steps down to a quarter pixel of travel. The result is therefore never less sharp than the events as they
 * are.
 */
final class SingleTranslation {
    private static final int STEPS = 16;
    private static final int COARSE_EVENTS = 3000;
    private static final int PEAKS = 12;
    private static final int IMPROVED_PEAKS = 3;
    private static final double FIRST_STEP_PX = 1;
    private static final double LAST_STEP_PX = 0.25;
    private static final int MOST_MOVES = 32;

    private final SensorSize sensor;
    private final EventPicture picture;
    private final int[] cells;
    private double vxPxPerS;
    private double vyPxPerS;
    private double variance;

    /** A travel over the window in px, and the variance of the picture of the events moved by this travel. */
    private record Travel(double x, double y, double variance) {
    }

    /** Some of a window's events: position in px, and time from the window's middle, in units of the window. */
    private record Sample(double[] x, double[] y, double[] time) {
    }

    SingleTranslation(SensorSize sensor) {
        this.sensor = sensor;
        picture = new EventPicture(sensor);
        cells = new int[(sensor.width() + 1) * (sensor.height() + 1)];
    }

    /** Velocity found last, to the right, in px/s. */
    double vxPxPerS() {
        return vxPxPerS;
    }

    /** Velocity found last, downwards, in px/s. */
    double vyPxPerS() {
        return vyPxPerS;
    }

    /** Variance of the picture of the events moved along the velocity found last. */
    double variance() {
        return variance;
    }

    /** Takes a velocity that was found before, and measures the variance of the picture. */
    void take(MovedEvents events, double knownVxPxPerS, double knownVyPxPerS) {
        vxPxPerS = knownVxPxPerS;
        vyPxPerS = knownVyPxPerS;
        events.drawMovedBy(picture, vxPxPerS, vyPxPerS);
        variance = picture.variance();
    }

    /** Searches for the best velocity of a window's events. */
    void find(MovedEvents events) {
        events.drawAsTheyAre(picture);
        Travel best = new Travel(0, 0, picture.variance());
        variance = best.variance;
        double windowS = (events.lastUs() - events.firstUs()) * 1e-6;
        if (windowS > 0) {
            List<Travel> starts = new ArrayList<>(peaks(sample(events)));
            starts.add(new Travel(vxPxPerS * windowS, vyPxPerS * windowS, 0));
            starts.add(best);
            for (Travel start : starts) {
                Travel improved = improve(events, windowS, start);
                // The first of equals wins; the order of the starts is fixed.
                if (improved.variance > best.variance) {
                    best = improved;
                }
            }
            take(events, best.x / windowS, best.y / windowS);
        } else {
            vxPxPerS = 0;
            vyPxPerS = 0;
        }
    }

    private static Sample sample(MovedEvents events) {
        int every = (events.size() + COARSE_EVENTS - 1) / COARSE_EVENTS;
        int n = (events.size() + every - 1) / every;
        Sample sample = new Sample(new double[n], new double[n], new double[n]);
        double windowS = (events.lastUs() - events.firstUs()) * 1e-6;
        for (int k = 0; k < n; k++) {
            int i = k * every;
            sample.x[k] = events.x(i);
            sample.y[k] = events.y(i);
            sample.time[k] = events.fromMiddleS(i) / windowS;
        }
        return sample;
    }

    private List<Travel> peaks(Sample sample) {
        double range = Math.max(sensor.width(), sensor.height()) / 2.0;
        double step = Math.max(1, range / STEPS);
        int steps = (int) (range / step);
        int side = 2 * steps + 1;
        double[] variances = new double[side * side];
        for (int k = 0; k < variances.length; k++) {
            variances[k] = coarseVariance(sample, (k % side - steps) * step, (k / side - steps) * step, step);
        }
        List<Travel> peaks = new ArrayList<>();
        for (int k = 0; k < variances.length; k++) {
            if (isPeak(variances, side, k)) {
                peaks.add(new Travel((k % side - steps) * step, (k / side - steps) * step, variances[k]));
            }
        }
        peaks = best(peaks, PEAKS);
        while (step > FIRST_STEP_PX) {
            step /= 2;
            double cell = Math.max(1, step);
            List<Travel> finer = new ArrayList<>();
            for (Travel peak : peaks) {
                Travel best = null;
                for (int k = 0; k < 9; k++) {
                    double x = peak.x + (k % 3 - 1) * step;
                    double y = peak.y + (k / 3 - 1) * step;
                    double reached = coarseVariance(sample, x, y, cell);
                    if (best == null || reached > best.variance) {
                        best = new Travel(x, y, reached);
                    }
                }
                finer.add(best);
            }
            peaks = finer;
        }
        return best(peaks, IMPROVED_PEAKS);
    }

    private static List<Travel> best(List<Travel> travels, int most) {
        return travels.stream().sorted(Comparator.comparingDouble(travel -> -travel.variance)).limit(most).toList();
    }

    private static boolean isPeak(double[] variances, int side, int k) {
        int column = k % side;
        int row = k / side;
        for (int y = Math.max(0, row - 1); y <= Math.min(side - 1, row + 1); y++) {
            for (int x = Math.max(0, column - 1); x <= Math.min(side - 1, column + 1); x++) {
                if (variances[y * side + x] > variances[k]) {
                    return false;
                }
            }
        }
        return true;
    }

    private double coarseVariance(Sample sample, double travelX, double travelY, double cell) {
        int columns = (int) (sensor.width() / cell) + 1;
        int rows = (int) (sensor.height() / cell) + 1;
        Arrays.fill(cells, 0, columns * rows, 0);
        double perCell = 1 / cell;
        long squares = 0;
        long sum = 0;
        double[] xs = sample.x;
        double[] ys = sample.y;
        double[] times = sample.time;
        for (int i = 0; i < xs.length; i++) {
            double x = xs[i] - travelX * times[i] + 0.5;
            double y = ys[i] - travelY * times[i] + 0.5;
            if (x >= 0 && x < sensor.width() && y >= 0 && y < sensor.height()) {
                int count = cells[(int) (y * perCell) * columns + (int) (x * perCell)]++;
                squares += 2 * count + 1;
                sum++;
            }
        }
        double size = (double) columns * rows;
        return squares / size - sum / size * (sum / size);
    }

    /** Climbs from a travel to a local maximum of the picture's variance. */
    private Travel improve(MovedEvents events, double windowS, Travel start) {
        Travel best = exactly(events, windowS, start.x, start.y);
        double step = FIRST_STEP_PX;
        for (int moves = 0; step >= LAST_STEP_PX && moves < MOST_MOVES; moves++) {
            Travel centre = best;
            for (int k = 0; k < 9; k++) {
                if (k != 4) {
                    Travel tried = exactly(events, windowS, centre.x + (k % 3 - 1) * step,
                        centre.y + (k / 3 - 1) * step);
                    if (tried.variance > best.variance) {
                        best = tried;
                    }
                }
            }
            if (best == centre) {
                step /= 2;
            }
        }
        return best;
    }

    private Travel exactly(MovedEvents events, double windowS, double travelX, double travelY) {
        events.drawMovedBy(picture, travelX / windowS, travelY / windowS);
        return new Travel(travelX, travelY, picture.variance());
    }
}
