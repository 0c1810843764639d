package io.github.sofas.flow.fit;

/**
 * Fits each change of a motion separately, around the motion that the events were projected along and whose velocity
 * was fitted just before. Each fit describes the metric along the change by a parabola, which is valid until the next
 * fit.
 */
interface ChangeFit {
    /** Standard deviations of the metric by which it must curve along a change for a step to its top. */
    double CHANGE_SIGMAS = 0.5;
    /** Distance of the projections that measure a change, at the end of the window, in px. */
    double APART_PX = 1.5;

    /** Fits the acceleration along (dirX, dirY) with neighbours h px/s² apart. */
    Parabola acceleration(double dirX, double dirY, double h);

    /** Fits the rotation with neighbours h rad/s apart. */
    Parabola rotation(double h);

    /** Fits the change of the rotation with neighbours h rad/s² apart. */
    Parabola spin(double h);

    /** Fits the growth with neighbours h per s apart. */
    Parabola growth(double h);
}
