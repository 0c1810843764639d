package io.github.sofas.flow.fit;

/** Fits changes of a motion by the slopes of the metric, with no projection beside it. */
final class SlopedChange implements ChangeFit {
    private final MetricSlopes slopes;
    private final Parabola fitted = new Parabola();

    /** Makes fits by slopes, which must be those of the present events at each call. */
    SlopedChange(MetricSlopes slopes) {
        this.slopes = slopes;
    }

    @Override
    public Parabola acceleration(double dirX, double dirY, double h) {
        return along(slopes.ax * dirX + slopes.ay * dirY, slopes.loss(dirX, dirY, dirX, dirY) * slopes.changeShare, h);
    }

    @Override
    public Parabola rotation(double h) {
        return along(slopes.turn, slopes.lossTurn, h);
    }

    @Override
    public Parabola spin(double h) {
        return along(slopes.spin, slopes.lossTurn * slopes.changeShare, h);
    }

    @Override
    public Parabola growth(double h) {
        return along(slopes.grow, slopes.lossGrow, h);
    }

    private Parabola along(double rise, double loss, double h) {
        return fitted.along(rise, loss, h, Parabola.floor(slopes.metric, CHANGE_SIGMAS));
    }
}
