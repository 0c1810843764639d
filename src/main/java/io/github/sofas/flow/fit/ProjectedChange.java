package io.github.sofas.flow.fit;

/** Fits changes of a motion by two projections, one on each side of it. */
final class ProjectedChange implements ChangeFit {
    private final Metric metric;
    private final double[] lessAndMore = new double[2];
    private final Parabola fitted = new Parabola();
    private double here;

    ProjectedChange(Metric metric) {
        this.metric = metric;
    }

    /** Continues with events whose metric along the motion itself is known. */
    ProjectedChange around(double metricHere) {
        here = metricHere;
        return this;
    }

    @Override
    public Parabola acceleration(double dirX, double dirY, double h) {
        metric.alongAcceleration(dirX, dirY, h, lessAndMore);
        return through(h);
    }

    @Override
    public Parabola rotation(double h) {
        metric.alongRotation(h, lessAndMore);
        return through(h);
    }

    @Override
    public Parabola spin(double h) {
        metric.alongSpin(h, lessAndMore);
        return through(h);
    }

    @Override
    public Parabola growth(double h) {
        metric.alongGrowth(h, lessAndMore);
        return through(h);
    }

    private Parabola through(double h) {
        double less = lessAndMore[0];
        double more = lessAndMore[1];
        double floor = Parabola.floor(Math.max(here, Math.max(less, more)), CHANGE_SIGMAS);
        return fitted.through(less, here, more, h, floor);
    }
}
