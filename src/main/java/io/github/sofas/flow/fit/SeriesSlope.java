package io.github.sofas.flow.fit;

/**
 * How fast a parameter of the motion changes, from one measurement of it to the next. Ours, because within one window
 * the metric shows too little of it: what comes near at a steady speed grows faster and faster, and a camera moved by
 * hand accelerates now one way, now the other.
 *
 * <p>A mean of the slopes between measurements, over about half a window; none until the parameter has settled, because
 * the first measurements come from nothing and look like a steep rise.
 */
final class SeriesSlope {
    /** Correction of a measurement at the end of the window, in px, above which the parameter has not settled. */
    private static final double UNSETTLED_PX = 0.3;
    /**
     * Difference from the value before, in px at the end of the window, above which one that was not measured is that
     * of another structure: a piece of a picture that grows shows little growth, and the whole picture all of it.
     */
    private static final double ANOTHER_PX = 0.1;
    /** Part of half a window that must be new since it was unsettled. */
    private static final double LEAST_NEWS = 0.6;

    private double slope;
    /** Mean square of what slopes between two measurements differ from their mean by. */
    private double scatter;
    /** Mean part of half a window that two measurements lie apart by. */
    private double apart;
    private double before;
    private long beforeUs;
    /** Whether there is a value before. */
    private boolean follows;
    /** Half windows that were measured since the parameter settled. */
    private double news;

    /** Begins without measurements. */
    void restart() {
        slope = 0;
        scatter = 0;
        apart = 0;
        news = 0;
        follows = false;
    }

    /**
     * Takes a measurement.
     *
     * @param value of the parameter in the middle of the window
     * @param timeUs the middle of the window; one that is no later than that before tells nothing of the slope
     * @param step correction of the parameter by this measurement
     * @param perPx what shifts the end of the window by a px
     * @param half half the window in s
     */
    void measured(double value, long timeUs, double step, double perPx, double half) {
        double seconds = (timeUs - beforeUs) * 1e-6;
        boolean isOfAnother = !follows && Math.abs(value - before) > ANOTHER_PX * perPx;
        if (isOfAnother || Math.abs(step) > UNSETTLED_PX * perPx) {
            slope = 0;
            scatter = 0;
            news = 0;
        } else if (follows && seconds > 0) {
            double part = Math.min(1, seconds / half);
            news += part;
            if (news > LEAST_NEWS) {
                double off = (value - before) / seconds - slope;
                apart += part * (part - apart);
                scatter += part / 2 * (off * off - scatter);
                slope += part * off;
            }
        }
        before = value;
        beforeUs = timeUs;
        follows = true;
    }

    /** Keeps a share of the slope where nothing can be measured. */
    void hold(double share) {
        slope *= share;
    }

    /** Goes on from a value that was not measured: what leads there is no slope, or that of another structure. */
    void skip() {
        follows = false;
    }

    /**
     * What noise of the measurements may make of the slope, a second: of slopes between neighbours, which share a value
     * each, the first and the last value are left in a mean, so that it differs by as much less as there are of them.
     */
    double noisePerS() {
        return Math.sqrt(scatter) * apart;
    }

    /** Change of the parameter a second; 0 where it is not known. */
    double perS() {
        return slope;
    }
}
