package io.github.sofas.flow.smooth;

import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.fit.MeetingPicture;
import java.util.Arrays;

/**
 * By how much the way along an aligned path is to be lengthened. An edge fires several times at each pixel, and the
 * events after the first come late by times that differ from pixel to pixel. A path that is too short draws them
 * together, as errors in the times flatten a regression line: of a way of 7 px, a tenth is lost. Ours: the first events
 * alone are moved along a shorter and along a longer way, and the top of the parabola through how often they meet shows
 * the length. They are too few to align the path by.
 */
final class PathLength {
    /** Way, in px, after which an event of the same pixel and polarity is a first event again. */
    private static final int FIRST_PX = 3;
    /** Difference of the ways that are compared, as a share of the way, and how often they are compared. */
    private static final double STEP = 0.1;
    private static final int ROUNDS = 2;
    /**
     * Variance of the places of late events about their edge, in px² at most. As in a regression, the way is too short
     * by the share of that in its own variance.
     */
    private static final double MOST_LATE_PX2 = 0.5;
    /** Least variance of the way, in px²: where less is swung to and fro, hardly any event is a first event. */
    private static final double LEAST_WAY_PX2 = 2;
    private static final int NONE = -1;

    private final int columns;
    private final MeetingPicture picture;
    /** By pixel and polarity, the last first event. */
    private final int[] last;
    // where the first events were, and where they are at the reference time
    private final int[] fromX;
    private final int[] fromY;
    private final int[] toX;
    private final int[] toY;
    private int firsts;

    /**
     * Creates an instance for at most so many events.
     *
     * @param picture may be used for anything else between two calls
     */
    PathLength(SensorSize sensor, int mostEvents, MeetingPicture picture) {
        this.picture = picture;
        columns = sensor.width();
        last = new int[pixels(sensor)];
        Arrays.fill(last, NONE);
        fromX = new int[mostEvents];
        fromY = new int[mostEvents];
        toX = new int[mostEvents];
        toY = new int[mostEvents];
    }

    private static int pixels(SensorSize sensor) {
        return 2 * sensor.width() * sensor.height();
    }

    /** Bytes of its arrays. */
    static long bytes(SensorSize sensor, int mostEvents) {
        return Integer.BYTES * (pixels(sensor) + 4L * mostEvents);
    }

    /** Number that stands for the pixel and the polarity of an event. */
    int pixel(int x, int y, int polarity) {
        return 2 * (y * columns + x) + (polarity > 0 ? 1 : 0);
    }

    /**
     * Factor of the way along the path, 1 or greater.
     *
     * @param pixel of each event, as {@link #pixel} numbers it; in order of time
     * @param x places of the events at the reference time, along the path, as {@link MeetingPicture#place} gives them
     * @param events how many there are, one at least
     */
    double factor(int[] pixel, int[] x, int[] y, int events) {
        findFirsts(pixel, x, y, events);
        double way = variance();
        if (way < LEAST_WAY_PX2) {
            return 1;
        }
        double most = 1 + MOST_LATE_PX2 / way;
        double factor = 1;
        for (int round = 0; round < ROUNDS; round++) {
            double shorter = met(factor - STEP);
            double longer = met(factor + STEP);
            double slope = (longer - shorter) / 2;
            double curvature = 2 * met(factor) - shorter - longer;
            factor += STEP * (curvature > Math.abs(slope) ? slope / curvature : Math.signum(slope));
        }
        return Math.max(1, Math.min(most, factor));
    }

    private void findFirsts(int[] pixel, int[] x, int[] y, int events) {
        int far = FIRST_PX * MeetingPicture.shift(1);
        firsts = 0;
        for (int i = 0; i < events; i++) {
            int before = last[pixel[i]];
            if (before == NONE || Math.abs(x[i] - toX[before]) + Math.abs(y[i] - toY[before]) >= far) {
                fromX[firsts] = MeetingPicture.place(pixel[i] / 2 % columns);
                fromY[firsts] = MeetingPicture.place(pixel[i] / 2 / columns);
                toX[firsts] = x[i];
                toY[firsts] = y[i];
                last[pixel[i]] = firsts++;
            }
        }
        for (int i = 0; i < events; i++) {
            last[pixel[i]] = NONE;
        }
    }

    /** Variance of the way of the first events to the reference time, in px². */
    private double variance() {
        double sumX = 0;
        double sumY = 0;
        double squares = 0;
        for (int k = 0; k < firsts; k++) {
            double wayX = toX[k] - fromX[k];
            double wayY = toY[k] - fromY[k];
            sumX += wayX;
            sumY += wayY;
            squares += wayX * wayX + wayY * wayY;
        }
        double px = MeetingPicture.shift(1);
        return (squares - (sumX * sumX + sumY * sumY) / firsts) / (firsts * px * px);
    }

    /** How often the first events meet where a multiple of the way takes them. */
    private double met(double times) {
        picture.clear();
        for (int k = 0; k < firsts; k++) {
            picture.add(along(times, fromX[k], toX[k]), along(times, fromY[k], toY[k]), 1);
        }
        double met = 0;
        for (int k = 0; k < firsts; k++) {
            met += picture.met(along(times, fromX[k], toX[k]), along(times, fromY[k], toY[k]), 1);
        }
        return met;
    }

    private static int along(double times, int from, int to) {
        return from + (int) Math.rint(times * (to - from));
    }
}
