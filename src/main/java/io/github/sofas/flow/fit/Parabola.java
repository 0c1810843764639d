package io.github.sofas.flow.fit;

/**
 * The metric along one parameter of the motion, as a parabola: through three values of the metric, or with a given
 * slope and loss. Each fit replaces the previous one.
 */
final class Parabola {
    private double step;
    private double loss;
    private double slope;

    /**
     * Lays the parabola through the metric here and at two neighbours.
     *
     * @param h distance of the neighbours, in the unit of the parameter
     * @param floor curvature, with neighbours at a distance of 1, that a top must pass
     */
    Parabola through(double less, double here, double more, double h, double floor) {
        double curvature = less + more - 2 * here;
        slope = (more - less) / 2;
        step = stepTo(curvature, slope, floor) * h;
        loss = -Math.min(curvature, 0) / 2 / (h * h);
        return this;
    }

    /**
     * Lays the parabola by slope and loss of the metric here.
     *
     * @param rise of the metric per unit of the parameter, and lossHere its loss per unit squared
     * @param h distance in which a step is counted, in the unit of the parameter
     * @param floor curvature, with neighbours at a distance of h, that a top must pass
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

    /** Rise of the metric from here to the neighbour above, without the part of the curvature. */
    double slope() {
        return slope;
    }

    /** Loss of metric per unit squared of the parameter; 0 where nothing is known of it. */
    double loss() {
        return loss;
    }

    /**
     * Curvature that equals so many standard deviations of a metric; 0 for a negative metric, where votes only cancel.
     */
    static double floor(double metric, double sigmas) {
        return -2 * sigmas * Math.sqrt(Math.max(0, metric));
    }

    /** Step to the top, in distances of neighbours. */
    static double stepTo(double curvature, double gradient, double floor) {
        if (curvature >= floor) {
            // no top, or no events that meet: a step uphill only where the slope is clear
            return Math.abs(gradient) > -floor ? Math.signum(gradient) : 0;
        }
        return Math.max(-1.5, Math.min(1.5, -gradient / curvature));
    }
}
