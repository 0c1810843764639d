package io.github.sofas.recording;

import io.github.sofas.event.SensorSize;

/**
 * Counts events outside the sensor, which are not delivered, and how far out they lie. Many of them show a wrong
 * sensor.
 */
final class OutsideEvents {
    /** Where a larger share of the events lies outside, the sensor is another one. */
    private static final double MOST_OUTSIDE = 0.1;
    private static final int FEWEST_OUTSIDE = 20;

    private final SensorSize sensor;
    private long count;
    private int greatestX;
    private int greatestY;

    OutsideEvents(SensorSize sensor) {
        this.sensor = sensor;
    }

    void add(int x, int y) {
        count++;
        greatestX = Math.max(greatestX, x);
        greatestY = Math.max(greatestY, y);
    }

    long count() {
        return count;
    }

    /**
     * The fault where too many events lie outside a sensor that the caller named; null where few do.
     *
     * @param asked the sensor as the caller named it
     * @param inside number of events on the sensor
     */
    String misfit(String asked, long inside) {
        long all = inside + count;
        if (count < FEWEST_OUTSIDE || count <= MOST_OUTSIDE * all) {
            return null;
        }
        String likely = Chip.known().stream().filter(chip -> chip.sensor().contains(greatestX, greatestY))
            .map(Chip::name).findFirst().map(name -> ", as of a " + name).orElse("");
        return "malformed, --chip " + asked + " must fit the events but of the first " + all + ", " + count
            + " lie outside " + sensor + ", at x up to " + greatestX + " and y up to " + greatestY + likely
            + "; --force-chip takes what lies within";
    }
}
