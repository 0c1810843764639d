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
 * The mean endpoint error is the AEE. The bound of an outlier is jAER's: KITTI's 3 px per image at EV-FlowNet's 45
 * images per second. The error of an object slower than about 100 px/s hardly ever reaches this bound. KITTI's second
 * bound, 5 %, is therefore counted separately.
 *
 * <p>Relative figures and angles need a true direction. Events whose true speed is below {@value #MIN_TRUE_SPEED} px/s
 * (in jAER: is 0) do not count in these figures, but they count in the endpoint error. An event with a segment whose
 * estimate is exactly 0 counts with a magnitude error of -100 % and has no angle; jAER treats it as an event without
 * flow.
 *
 * @param object id of the object; {@link #ALL_OBJECTS} for all objects together
 * @param events number of the object's events that count
 * @param eventsWithFlow number of those events that have flow
 * @param magnitudeErrorPercent signed, in %
 * @param directionErrorDeg signed, in degrees
 * @param angularErrorDeg unsigned, in degrees
 * @param endpointErrorPxPerS in px/s
 * @param relativeEndpointErrorPercent in %
 * @param outliers number of events with flow that are outliers
 * @param relativeOutliers number of events with flow and a true direction that are relative outliers
 * @param peakTrueSpeedPxPerS greatest true speed of the events that count, in px/s
 * @param runaways number of events with flow that are runaways
 */
public record FlowFigures(int object, long events, long eventsWithFlow, Distribution magnitudeErrorPercent,
                          Distribution directionErrorDeg, Distribution angularErrorDeg,
                          Distribution endpointErrorPxPerS, Distribution relativeEndpointErrorPercent, long outliers,
                          long relativeOutliers, double peakTrueSpeedPxPerS, long runaways) {
    /** In place of an object's id, stands for all objects together. */
    public static final int ALL_OBJECTS = -1;
    /** Smallest true speed that counts as having a direction, in px/s. */
    public static final double MIN_TRUE_SPEED = 1;
    /** Endpoint error above which an event is an outlier, in px/s: 3 px per image at 45 images per second. */
    public static final double OUTLIER_PX_PER_S = 3 * 45;
    /** Multiple of the greatest true speed above which an estimated speed is a runaway. */
    public static final double RUNAWAY_RATIO = 2;
    /** Relative endpoint error above which an event is a relative outlier, in %. */
    public static final double RELATIVE_OUTLIER_PERCENT = 5;

    /** {@return the share of the object's events that have flow; 0 if there are no events} */
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
     * {@return the mean endpoint error in % of the greatest true speed} Suits objects that reverse, whose |v| passes
     * through 0, so that the relative endpoint error means little.
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

    /** Accumulates the errors of events one by one. */
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

        /** Makes one for an object; {@code fastestPxPerS} is the greatest true speed of all objects' counted events. */
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
     * {@return the magnitude error of the estimate u, in %} The true velocity v must not be 0.
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
     * {@return the angle from the true velocity v to the estimate u, in degrees, in (-180, 180]} Positive angles are
     * clockwise on screen. The cross and dot product together keep tiny angles exact, unlike an arc cosine.
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
