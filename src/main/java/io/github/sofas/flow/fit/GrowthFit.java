package io.github.sofas.flow.fit;

import io.github.sofas.flow.motion.Motion;

/**
 * The growth of a structure, with the velocity that goes with it.
 *
 * <p>Ours: an edge gives the more events the faster it moves, so that of what comes near and moves on most events are
 * those of its front. These meet along one velocity, whatever the growth, so that the metric has a narrow ridge: from
 * the middle of the events, either of growth and velocity is best where the other is wrong, and measuring them in turn
 * took 10 px of travel to climb it. From the place where growth and velocity change the picture least alike, often the
 * front, the ridge lies along the growth, and either is best whatever the other is.
 */
final class GrowthFit {
    // place that stays where it is as the structure grows, from its centre in px
    private double fromX;
    private double fromY;
    private double perPx;
    private double step;
    private double growth;
    private double loss;
    private double gain;

    /**
     * Fits the growth of events whose velocity was fitted. By slopes, as of what is steady, it is about the centre, and
     * so it is of a plane, whose parameters {@link PlaneChange} measures all at once.
     *
     * @param structure of the pictures that the events made of late
     * @param grown growth that the events were projected along, in 1/s
     * @param half half the window in s
     * @param radius of the structure in px
     * @param isPlane whether it is measured as a plane, too
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
        // far from the growth the metric is no top yet, and only rises
        gain = isAboutCentre || loss > 0 || step == 0 ? ownLoss * growth * growth : Math.abs(fitted.slope());
    }

    /** Growth that shifts the ends of the window by a pixel at the radius, from the place that stays, in 1/s. */
    double perPx() {
        return perPx;
    }

    /** The growth, in 1/s. */
    double growth() {
        return growth;
    }

    /** How much it is beyond the one that the events were projected along. */
    double step() {
        return step;
    }

    /** What the metric gains by it. */
    double gain() {
        return gain;
    }

    /** What the metric loses per (1/s)² of growth about the centre. */
    double lossAboutCentre(MotionLoss of) {
        return loss + of.xx * fromX * fromX + 2 * of.xy * fromX * fromY + of.yy * fromY * fromY;
    }

    /** Gives a motion another growth, in 1/s, and its centre the velocity that goes with it. */
    void give(Motion motion, double next) {
        motion.vx -= (next - motion.growth) * fromX;
        motion.vy -= (next - motion.growth) * fromY;
        motion.growth = next;
    }
}
