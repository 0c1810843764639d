package io.github.sofas.evaluate;

/**
 * Agreement of two methods on the flow of one recording, for recordings whose truth is unknown.
 *
 * @param both number of events to which both methods gave flow
 * @param difference length of the difference of the two velocities, in px/s
 * @param angle angle between the two velocities, in degrees from 0 to 180, over the events where neither velocity is 0
 */
public record Agreement(long both, Distribution difference, Distribution angle) {

    /**
     * Compares two estimates event by event.
     *
     * @param a one estimate
     * @param b another estimate of the same events
     * @return the agreement of the two
     * @throws IllegalArgumentException if the estimates differ in their number of events
     */
    public static Agreement of(FlowEstimate a, FlowEstimate b) {
        if (a.size() != b.size()) {
            throw new IllegalArgumentException("estimates must be of equally many events but have " + a.size()
                + " and " + b.size());
        }
        Distribution.Gatherer difference = new Distribution.Gatherer();
        Distribution.Gatherer angle = new Distribution.Gatherer();
        long both = 0;
        for (int i = 0; i < a.size(); i++) {
            if (a.hasFlow(i) && b.hasFlow(i)) {
                both++;
                double ax = a.vxPxPerS(i);
                double ay = a.vyPxPerS(i);
                double bx = b.vxPxPerS(i);
                double by = b.vyPxPerS(i);
                difference.add(Math.hypot(ax - bx, ay - by));
                if ((ax != 0 || ay != 0) && (bx != 0 || by != 0)) {
                    angle.add(Math.abs(FlowFigures.directionErrorDeg(ax, ay, bx, by)));
                }
            }
        }
        return new Agreement(both, difference.distribution(), angle.distribution());
    }
}
