package io.github.sofas.evaluate;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * Maps every figure to its name, which is the same in text, JSON and CSV, and formats the values. A figure without any
 * events behind it is null.
 */
final class NamedFigures {
    private static final int DECIMALS = 6;

    private NamedFigures() {
    }

    static Map<String, Number> flow(FlowFigures flow) {
        Map<String, Number> figures = new LinkedHashMap<>();
        figures.put("events", flow.events());
        figures.put("events_with_flow", flow.eventsWithFlow());
        figures.put("share_with_flow", of(flow.shareWithFlow(), flow.events()));
        put(figures, "magnitude_error_percent", flow.magnitudeErrorPercent());
        put(figures, "direction_error_deg", flow.directionErrorDeg());
        put(figures, "angular_error_deg", flow.angularErrorDeg());
        put(figures, "endpoint_error_px_per_s", flow.endpointErrorPxPerS());
        put(figures, "relative_endpoint_error_percent", flow.relativeEndpointErrorPercent());
        figures.put("endpoint_error_percent_of_peak", of(flow.endpointErrorPercentOfPeak(), flow.eventsWithFlow()));
        figures.put("outlier_share", of(flow.outlierShare(), flow.eventsWithFlow()));
        figures.put("relative_outlier_share",
                of(flow.relativeOutlierShare(), flow.relativeEndpointErrorPercent().count()));
        figures.put("runaway_share", of(flow.runawayShare(), flow.eventsWithFlow()));
        return figures;
    }

    private static void put(Map<String, Number> figures, String name, Distribution distribution) {
        long count = distribution.count();
        figures.put(name + "_mean", of(distribution.mean(), count));
        figures.put(name + "_sd", of(distribution.sd(), count));
        figures.put(name + "_lower_quartile", of(distribution.lowerQuartile(), count));
        figures.put(name + "_median", of(distribution.median(), count));
        figures.put(name + "_upper_quartile", of(distribution.upperQuartile(), count));
    }

    static Map<String, Number> segmentation(SegmentationFigures segmentation) {
        Map<String, Number> figures = new LinkedHashMap<>();
        long pairs = segmentation.pairs();
        figures.put("windows", pairs);
        figures.put("iou_mean", of(segmentation.meanIou(), pairs));
        figures.put("iou_without_noise_mean", of(segmentation.meanIouWithoutNoise(), pairs));
        figures.put("iou_worst", of(segmentation.worstIou(), pairs));
        figures.put("parts_per_object", ofPositive(segmentation.partsPerObject()));
        figures.put("objects_per_part", ofPositive(segmentation.objectsPerPart()));
        figures.put("identity_changes", segmentation.identityChanges());
        figures.put("objects_labelled", segmentation.labelled());
        figures.put("first_labelled_ms", of(segmentation.firstLabelledUs() / 1e3, segmentation.labelled()));
        figures.put("first_labelled_px", of(segmentation.firstLabelledPx(), segmentation.labelled()));
        return figures;
    }

    static Map<String, Number> noise(Evaluation evaluation) {
        Map<String, Number> figures = new LinkedHashMap<>();
        figures.put("events", evaluation.noiseEvents());
        figures.put("events_with_flow", evaluation.noiseEventsWithFlow());
        figures.put("share_with_flow", of(evaluation.noiseShareWithFlow(), evaluation.noiseEvents()));
        return figures;
    }

    static Map<String, Number> convergence(ConvergenceBin bin) {
        Map<String, Number> figures = new LinkedHashMap<>();
        figures.put("from_ms", bin.fromUs() / 1e3);
        figures.put("until_ms", bin.untilUs() / 1e3);
        figures.put("events", bin.events());
        figures.put("share_with_flow", of(bin.shareWithFlow(), bin.events()));
        figures.put("magnitude_error_percent_mean", of(bin.meanMagnitudeErrorPercent(), bin.eventsWithFlow()));
        figures.put("angular_error_deg_mean", of(bin.meanAngularErrorDeg(), bin.eventsWithFlow()));
        figures.put("endpoint_error_px_per_s_mean", of(bin.meanEndpointErrorPxPerS(), bin.eventsWithFlow()));
        figures.put("relative_endpoint_error_percent_mean",
                of(bin.meanRelativeEndpointErrorPercent(), bin.eventsWithFlow()));
        return figures;
    }

    static Map<String, Number> sharpness(Sharpness sharpness) {
        Map<String, Number> figures = new LinkedHashMap<>();
        figures.put("windows", sharpness.windows().size());
        sharpness(figures, sharpness.events(), sharpness.eventsWithFlow(), sharpness.sharpness(),
                sharpness.translationSharpness());
        return figures;
    }

    static Map<String, Number> sharpness(SharpnessWindow window) {
        Map<String, Number> figures = new LinkedHashMap<>();
        figures.put("from_us", window.fromUs());
        figures.put("until_us", window.untilUs());
        sharpness(figures, window.events(), window.eventsWithFlow(), window.sharpness(),
                window.translationSharpness());
        figures.put("translation_vx_px_per_s", window.translationVxPxPerS());
        figures.put("translation_vy_px_per_s", window.translationVyPxPerS());
        return figures;
    }

    private static void sharpness(Map<String, Number> figures, long events, long eventsWithFlow, double sharpness,
                                  double translationSharpness) {
        figures.put("events", events);
        figures.put("share_with_flow", of(FlowFigures.share(eventsWithFlow, events), events));
        figures.put("sharpness", sharpness);
        figures.put("translation_sharpness", translationSharpness);
        figures.put("gain", Sharpness.hasGain(translationSharpness)
                ? (Number) Sharpness.gain(sharpness, translationSharpness) : null);
    }

    private static Number of(double value, long count) {
        return count == 0 ? null : value;
    }

    /** For means of counts that are at least 1: a value of 0 stands for no figure. */
    private static Number ofPositive(double value) {
        return value == 0 ? null : value;
    }

    /** Formats whole numbers as they are, and others with the given number of decimals, a point and no exponent. */
    static String text(Number value, int decimals) {
        if (value instanceof Double) {
            return BigDecimal.valueOf(value.doubleValue()).setScale(decimals, RoundingMode.HALF_UP).toPlainString();
        }
        return value.toString();
    }

    /** Formats a value for CSV and JSON. */
    static String text(Number value) {
        return text(value, DECIMALS);
    }

    /** Formats a value for the tables that people read. */
    static String shortText(Number value) {
        return value == null ? "-" : text(value, 3);
    }

    /** Appends one line per figure: section, of, figure, value. */
    static void appendCsv(StringBuilder csv, String section, String of, Map<String, Number> figures) {
        figures.forEach((figure, value) -> csv.append(section).append(',').append(of).append(',').append(figure)
                .append(',').append(value == null ? "" : text(value)).append('\n'));
    }

    /** Writes a JSON object with one field per figure. */
    static void write(JsonGenerator json, Map<String, Number> figures) throws IOException {
        json.writeStartObject();
        for (Map.Entry<String, Number> figure : figures.entrySet()) {
            json.writeFieldName(figure.getKey());
            write(json, figure.getValue());
        }
        json.writeEndObject();
    }

    static void write(JsonGenerator json, Number value) throws IOException {
        if (value == null) {
            json.writeNull();
        } else {
            json.writeNumber(text(value));
        }
    }
}
