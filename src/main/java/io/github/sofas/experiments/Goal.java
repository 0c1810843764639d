package io.github.sofas.experiments;

import io.github.sofas.evaluate.Evaluation;
import io.github.sofas.evaluate.SegmentationFigures;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.ToDoubleFunction;

/** A bound that the default preset should reach in a setting, by one or more figures of its evaluation. */
interface Goal {
    /** Travel, in px, within which every object should be labelled; or the time below, whichever is later. */
    double FIRST_LABELLED_PX = 8;
    /** Time, in ms, within which every object should be labelled; see {@link #FIRST_LABELLED_PX}. */
    double FIRST_LABELLED_MS = 40;

    /** Compares the default preset's figures with the goal; a relative goal also uses the figures of other methods. */
    Check check(Map<ComparedMethod, Evaluation> evaluations);

    /**
     * The comparison of a goal with the figure that was reached.
     *
     * @param figure name of the figure
     * @param goal the bound in words
     * @param reached the figure in words
     * @param met whether the figure is within the bound
     */
    record Check(String figure, String goal, String reached, boolean met) {
    }

    private static Check atMost(String figure, double bound, double reached, String unit) {
        return new Check(figure, "≤ " + text(bound) + unit, text(reached) + unit, Math.abs(reached) <= bound);
    }

    private static Check atLeast(String figure, double bound, double reached, String unit) {
        return new Check(figure, "≥ " + text(bound) + unit, text(reached) + unit, reached >= bound);
    }

    private static String text(double value) {
        return String.format(Locale.ROOT, "%.2f", value);
    }

    private static Goal atMost(String figure, double bound, String unit, ToDoubleFunction<Evaluation> reached) {
        return all -> atMost(figure, bound, reached.applyAsDouble(all.get(ComparedMethod.SOFAS_DEFAULT)), unit);
    }

    private static Goal atLeast(String figure, double bound, String unit, ToDoubleFunction<Evaluation> reached) {
        return all -> atLeast(figure, bound, reached.applyAsDouble(all.get(ComparedMethod.SOFAS_DEFAULT)), unit);
    }

    /** Bounds of the flow of one shape: magnitude in % and direction in degrees, mean and sd each; share in %. */
    static List<Goal> flow(double mean, double sd, double angle, double angleSd, double sharePercent) {
        return List.of(
            atMost("magnitude error, mean", mean, " %", e -> e.flow().magnitudeErrorPercent().mean()),
            atMost("magnitude error, sd", sd, " %", e -> e.flow().magnitudeErrorPercent().sd()),
            atMost("direction error, mean", angle, "°", e -> e.flow().directionErrorDeg().mean()),
            atMost("direction error, sd", angleSd, "°", e -> e.flow().directionErrorDeg().sd()),
            share(sharePercent));
    }

    /** Least share of the object events with flow, in %. */
    static Goal share(double percent) {
        return atLeast("object events with flow", percent, " %", e -> 100 * e.flow().shareWithFlow());
    }

    /** Greatest share of the noise events with flow, in %. */
    static Goal noise(double percent) {
        return atMost("noise events with flow", percent, " %", e -> 100 * e.noiseShareWithFlow());
    }

    /** Greatest mean endpoint error, in % of the peak speed. */
    static Goal endpointOfPeak(double percent) {
        return atMost("AEE, of the peak speed", percent, " %", e -> e.flow().endpointErrorPercentOfPeak());
    }

    /** A mean relative endpoint error that is no greater than another method's. */
    static Goal relativeEndpointBelow(ComparedMethod other) {
        ToDoubleFunction<Evaluation> figure = e -> e.flow().relativeEndpointErrorPercent().mean();
        return all -> atMost("relative AEE, " + other.title().toLowerCase(Locale.ROOT) + "'", figure.applyAsDouble(
            all.get(other)), figure.applyAsDouble(all.get(ComparedMethod.SOFAS_DEFAULT)), " %");
    }

    /** Least mean intersection over union. */
    static Goal iou(double bound) {
        return atLeast("IoU", bound, "", e -> e.segmentation().meanIou());
    }

    /** Greatest number of parts per object. */
    static Goal parts(double bound) {
        return atMost("parts an object", bound, "", e -> e.segmentation().partsPerObject());
    }

    /** Requires every object to be labelled within {@link #FIRST_LABELLED_PX} or {@link #FIRST_LABELLED_MS}. */
    static Goal firstLabelled() {
        return all -> {
            boolean met = true;
            String worst = "never";
            double most = -1;
            for (SegmentationFigures object : all.get(ComparedMethod.SOFAS_DEFAULT).segmentationByObject()) {
                double ms = object.firstLabelledUs() / 1e3;
                met &= object.labelled() > 0
                    && (object.firstLabelledPx() <= FIRST_LABELLED_PX || ms <= FIRST_LABELLED_MS);
                if (object.firstLabelledPx() > most) {
                    most = object.firstLabelledPx();
                    worst = String.format(Locale.ROOT, "%.1f px, %.0f ms", most, ms);
                }
            }
            return new Check("first labelled", "8 px or 40 ms", worst, met);
        };
    }
}
