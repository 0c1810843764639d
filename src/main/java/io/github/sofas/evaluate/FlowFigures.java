package io.github.sofas.evaluate;

/**
 * Errors of the flow over the events of one object, or of all objects together.
 *
 * <p>With the true velocity v and the estimate u of an event that has flow (its segment is not 0):
 * <pre>
 *   magnitude error            100 (|u| - |v|) / |v|                     %, signed
 *   direction error            angle from v to u, in (-180, 180]         degrees, signed, positive clockwise on screen
 *   angular error              |direction error|                         degrees (jAER's)
 *   endpoint error             |u - v|                                   px/s
 *   relative endpoint error    100 |u - v| / |v|                         %
 *   outlier                    |u - v| &gt; 135 px/s
 *   relative outlier           |u - v| &gt; 0.05 |v|
 *   runaway                    |u| &gt; 2 max |v|, over all objects' events that count
 * </pre>
 * The mean endpoint error is the AEE. An outlier is jAER's: KITTI's 3 px an image at EV-FlowNet's 45 images per second;
 * since no object slower than about 100 px/s can well miss by that, KITTI's second bound, 5 %, is counted for itself.
 *
 * <p>Relative figures and angles need a true direction: events whose true speed is below {@value #MIN_TRUE_SPEED} px/s
 * (jAER: is 0) do not count in them, but do in the endpoint error. An event whose estimate is exactly 0 but that has a
 * segment counts, with a magnitude error of -100 %, and has no angle; jAER takes it for an event without flow.
 *
 * @param object the object's id; {@link #ALL_OBJECTS} for all together
 * @param events events of the object that count
 * @param eventsWithFlow those of them that have flow
 * @param magnitudeErrorPercent signed, in %
 * @param directionErrorDeg signed, in degrees
 * @param angularErrorDeg unsigned, in degrees
 * @param endpointErrorPxPerS in px/s
 * @param relativeEndpointErrorPercent in %
 * @param outliers events with flow that are outliers
 * @param relativeOutliers events with flow that are relative outliers, of those that have a true direction
 * @param peakTrueSpeedPxPerS greatest true speed of an event that counts
 * @param runaways events with flow that are runaways
 */
public record FlowFigures(int object, long events, long eventsWithFlow, Distribution magnitudeErrorPercent,
                          Distribution directionErrorDeg, Distribution angularErrorDeg,
                          Distribution endpointErrorPxPerS, Distribution relativeEndpointErrorPercent, long outliers,
                          long relativeOutliers, double peakTrueSpeedPxPerS, long runaways) {
    /** Stands for all objects together. */
    public static final int ALL_OBJECTS = -1;
    /** Slowest true speed that has a direction, in px/s. */
    public static final double MIN_TRUE_SPEED = 1;
    /** An endpoint error above this is an outlier, in px/s. */
    public static final double OUTLIER_PX_PER_S = 3 * 45;
    /** A speed above this multiple of the fastest true one is a runaway. */
    public static final double RUNAWAY_RATIO = 2;
    /** A relative endpoint error above this is a relative outlier, in %. */
    public static final double RELATIVE_OUTLIER_PERCENT = 5;

    /** {@return the share of the object's events that have flow, 0 where there are none} */
    public double shareWithFlow() {
        return share(eventsWithFlow, events);
    }

    /** {@return the share of outliers among the events with flow} */
    public double outlierShare() {
        return share(outliers, eventsWithFlow);
    }

    /** {@return the share of relative outliers among the events that have a relative endpoint error} */
    public double relativeOutlierShare() {
        return share(relativeOutliers, relativeEndpointErrorPercent.count());
    }

    /**
     * {@return the mean endpoint error in % of the greatest true speed} For objects that turn round, where |v| passes
     * 0.
     */
    public double endpointErrorPercentOfPeak() {
        return peakTrueSpeedPxPerS == 0 ? 0 : 100 * endpointErrorPxPerS.mean() / peakTrueSpeedPxPerS;
    }

    /** {@return the share of runaways among the events with flow} */
    public double runawayShare() {
        return share(runaways, eventsWithFlow);
    }

    static double share(long part, long whole) {
        return whole == 0 ? 0 : (double) part / whole;
    }

    /** Sums up events one by one. */
    static final class Gatherer {
        private final int object;
        private final Distribution.Gatherer magnitude = new Distribution.Gatherer();
        private final Distribution.Gatherer direction = new Distribution.Gatherer();
        private final Distribution.Gatherer angle = new Distribution.Gatherer();
        private final Distribution.Gatherer endpoint = new Distribution.Gatherer();
        private final Distribution.Gatherer relative = new Distribution.Gatherer();
        private long events;
        private long eventsWithFlow;
        private long outliers;
        private long relativeOutliers;
        private final double runawayPxPerS;
        private double peak;
        private long runaways;

        /** Makes one; the fastest true speed is that of any object's event that counts. */
        Gatherer(int object, double fastestPxPerS) {
            this.object = object;
            runawayPxPerS = RUNAWAY_RATIO * fastestPxPerS;
        }

        void add(GroundTruth truth, FlowEstimate estimate, int i) {
            double vx = truth.vxPxPerS()[i];
            double vy = truth.vyPxPerS()[i];
            double speed = Math.hypot(vx, vy);
            events++;
            peak = Math.max(peak, speed);
            if (!estimate.hasFlow(i)) {
                return;
            }
            eventsWithFlow++;
            double ux = estimate.vxPxPerS(i);
            double uy = estimate.vyPxPerS(i);
            runaways += Math.hypot(ux, uy) > runawayPxPerS ? 1 : 0;
            double error = Math.hypot(ux - vx, uy - vy);
            endpoint.add(error);
            if (error > OUTLIER_PX_PER_S) {
                outliers++;
            }
            if (speed < MIN_TRUE_SPEED) {
                return;
            }
            magnitude.add(magnitudeErrorPercent(vx, vy, ux, uy));
            double relativeError = 100 * error / speed;
            relative.add(relativeError);
            if (relativeError > RELATIVE_OUTLIER_PERCENT) {
                relativeOutliers++;
            }
            if (ux != 0 || uy != 0) {
                double degrees = directionErrorDeg(vx, vy, ux, uy);
                direction.add(degrees);
                angle.add(Math.abs(degrees));
            }
        }

        FlowFigures figures() {
            return new FlowFigures(object, events, eventsWithFlow, magnitude.distribution(),
                    direction.distribution(), angle.distribution(), endpoint.distribution(),
                    relative.distribution(), outliers, relativeOutliers, peak, runaways);
        }
    }

    /**
     * {@return the magnitude error of the estimate u of the true velocity v, which is not 0, in %}
     *
     * @param vx true velocity to the right, px/s
     * @param vy true velocity downwards, px/s
     * @param ux estimated velocity to the right, px/s
     * @param uy estimated velocity downwards, px/s
     */
    public static double magnitudeErrorPercent(double vx, double vy, double ux, double uy) {
        double speed = Math.hypot(vx, vy);
        return 100 * (Math.hypot(ux, uy) - speed) / speed;
    }

    /**
     * {@return the angle from the true velocity v to the estimate u, in degrees, above -180 to 180} Positive is
     * clockwise on screen. The cross and dot product together keep tiny angles exact, which an arc cosine does not.
     *
     * @param vx true velocity to the right, px/s
     * @param vy true velocity downwards, px/s
     * @param ux estimated velocity to the right, px/s
     * @param uy estimated velocity downwards, px/s
     */
    public static double directionErrorDeg(double vx, double vy, double ux, double uy) {
        return Math.toDegrees(Math.atan2(vx * uy - vy * ux, vx * ux + vy * uy));
    }
}
