package io.github.sofas.flow.fit;

/**
 * How fast a parameter of the motion changes from one measurement of it to the next. Ours, because the metric of a
 * single window shows too little of the change: a body that approaches at a steady speed grows faster and faster, and a
 * camera moved by hand accelerates now one way, now the other.
 *
 * <p>The result is a mean of the slopes between measurements, over about half a window. There is none until the
 * parameter has settled, because the first measurements start from nothing and look like a steep rise.
 */
final class SeriesSlope {
    /** Correction by a measurement, in px at the end of the window, above which the parameter has not settled. */
    private static final double UNSETTLED_PX = 0.3;
    /**
     * Difference from the value before, in px at the end of the window, above which a value that follows an unmeasured
     * one belongs to another structure: a piece of a growing picture shows little growth, and the whole picture all of
     * it.
     */
    private static final double ANOTHER_PX = 0.1;
    /** Part of half a window that must be new since the parameter was unsettled. */
    private static final double LEAST_NEWS = 0.6;

    private double slope;
    /** Mean square deviation of the slopes between two measurements from their mean. */
    private double scatter;
    /** Mean distance of two measurements in time, as a part of half a window. */
    private double apart;
    private double before;
    private long beforeUs;
    /** Whether there is a value before. */
    private boolean follows;
    /** Number of half windows that were measured since the parameter settled. */
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
     * @param timeUs the middle of the window; if it is no later than the one before, it shows nothing of the slope
     * @param step correction of the parameter by this measurement
     * @param perPx value that shifts the end of the window by one pixel
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

    /**
     * Continues from a value that was not measured: the way to the next one is no slope, or that of another structure.
     */
    void skip() {
        follows = false;
    }

    /**
     * Error that noise of the measurements may cause in the slope, per second. Neighbouring slopes share a value each,
     * so that only the first and the last value are left in their mean. The mean deviates the less, the more slopes
     * there are.
     */
    double noisePerS() {
        return Math.sqrt(scatter) * apart;
    }

    /** Change of the parameter per second; 0 where it is not known. */
    double perS() {
        return slope;
    }
}
