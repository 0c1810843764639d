package io.github.sofas.flow.fit;

import io.github.sofas.flow.motion.Motion;

/**
 * The growth of a structure, with the velocity that belongs to it.
 *
 * <p>Ours: the faster an edge moves, the more events it gives. A body that approaches while it travels thus gives most
 * of its events at its front. These meet along one velocity, whatever the growth, so that the metric has a narrow
 * ridge. Measured from the middle of the events, growth and velocity are each best where the other is wrong, and
 * measuring them in turn took 10 px of travel to climb the ridge. From the place where growth and velocity change the
 * picture least alike, often the front, the ridge lies along the axis of growth, and each is best whatever the other
 * is.
 */
final class GrowthFit {
    // place that stays fixed while the structure grows, in px from its centre
    private double fromX;
    private double fromY;
    private double perPx;
    private double step;
    private double growth;
    private double loss;
    private double gain;

    /**
     * Fits the growth of events whose velocity was fitted. A fit by slopes, as for a steady motion, is about the
     * centre; so is that of a plane, whose parameters {@link PlaneChange} measures all at once.
     *
     * @param structure of the recent pictures of the events
     * @param grown growth that the events were projected along, in 1/s
     * @param half half the window in s
     * @param radius of the structure in px
     * @param isPlane whether the structure is measured as a plane, too
     */
    void measure(MetricFit fit, StructureTensor structure, double grown, double half, double radius,
                 boolean isPlane) {
        boolean isAboutCentre = isPlane || fit.isSloped();
        fromX = isAboutCentre ? 0 : radius * structure.growsFromX();
        fromY = isAboutCentre ? 0 : radius * structure.growsFromY();
        fit.growFrom(fromX, fromY);
        perPx = 1 / (half * Math.sqrt(radius * radius + fromX * fromX + fromY * fromY));
        Parabola fitted = fit.changes().growth(perPx * ChangeFit.APART_PX);
        step = fitted.step();
        growth = grown + step;
        loss = fitted.loss();
        double ownLoss = isAboutCentre ? loss * structure.own(StructureTensor.GROW) : loss;
        // far from the growth, the metric has no top yet and only rises
        gain = isAboutCentre || loss > 0 || step == 0 ? ownLoss * growth * growth : Math.abs(fitted.slope());
    }

    /** Growth, from the fixed place, that shifts the ends of the window by a pixel at the radius, in 1/s. */
    double perPx() {
        return perPx;
    }

    /** The growth, in 1/s. */
    double growth() {
        return growth;
    }

    /** Difference from the growth that the events were projected along, in 1/s. */
    double step() {
        return step;
    }

    /** What the metric gains by the growth. */
    double gain() {
        return gain;
    }

    /** What the metric loses per (1/s)² of growth about the centre. */
    double lossAboutCentre(MotionLoss of) {
        return loss + of.xx * fromX * fromX + 2 * of.xy * fromX * fromY + of.yy * fromY * fromY;
    }

    /** Sets another growth of a motion, in 1/s, and the velocity of the centre that belongs to it. */
    void give(Motion motion, double next) {
        motion.vx -= (next - motion.growth) * fromX;
        motion.vy -= (next - motion.growth) * fromY;
        motion.growth = next;
    }
}
