package io.github.sofas.evaluate;

/**
 * How far two methods agree on the flow of one recording, where nothing knows the truth.
 *
 * @param both events that both gave flow
 * @param difference length of the difference of their velocities in px/s
 * @param angle angle between them in degrees, 0 to 180; of events where neither velocity is 0
 */
public record Agreement(long both, Distribution difference, Distribution angle) {

    /**
     * Compares event by event.
     *
     * @param a one estimate
     * @param b another, of the same events
     * @return how far they agree
     * @throws IllegalArgumentException where they are not of equally many events
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
