package io.github.sofas.flow.fit;

/**
 * The metric along one parameter of the motion, as a parabola through three values shows it, or one of the same slope
 * and loss; fit by fit anew.
 */
final class Parabola {
    private double step;
    private double loss;
    private double slope;

    /**
     * Lays it through the metric here and at two neighbours.
     *
     * @param h distance of the neighbours, in the unit of the parameter
     * @param floor curvature, of neighbours at a distance of 1, that a top must pass
     */
    Parabola through(double less, double here, double more, double h, double floor) {
        double curvature = less + more - 2 * here;
        slope = (more - less) / 2;
        step = stepTo(curvature, slope, floor) * h;
        loss = -Math.min(curvature, 0) / 2 / (h * h);
        return this;
    }

    /**
     * Lays it along what the metric changes by here.
     *
     * @param rise of the metric per unit of the parameter, and what it loses per unit squared
     * @param h distance that a step is taken in, in the unit of the parameter
     * @param floor curvature, of neighbours at a distance of h, that a top must pass
     */
    Parabola along(double rise, double lossHere, double h, double floor) {
        slope = rise * h;
        step = stepTo(-2 * lossHere * h * h, slope, floor) * h;
        loss = Math.max(0, lossHere);
        return this;
    }

    /** Step to the top, in the unit of the parameter. */
    double step() {
        return step;
    }

    /** What the metric rises by from here to the neighbour above, of the part that a slope makes. */
    double slope() {
        return slope;
    }

    /** Loss of metric per unit squared of the parameter; 0 where nothing is known of it. */
    double loss() {
        return loss;
    }

    /** Curvature that so many standard deviations of a metric make; where votes only cancel, there are none. */
    static double floor(double metric, double sigmas) {
        return -2 * sigmas * Math.sqrt(Math.max(0, metric));
    }

    /** Step to the top, in distances of neighbours. */
    static double stepTo(double curvature, double gradient, double floor) {
        if (curvature >= floor) {
            // not a top, or no events that meet: uphill only where the slope is clear
            return Math.abs(gradient) > -floor ? Math.signum(gradient) : 0;
        }
        return Math.max(-1.5, Math.min(1.5, -gradient / curvature));
    }
}
