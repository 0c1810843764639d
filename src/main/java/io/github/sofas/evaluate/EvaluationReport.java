package io.github.sofas.evaluate;

import com.fasterxml.jackson.core.JsonGenerator;
import io.github.sofas.export.Json;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * Report of an evaluation, as text for people and as CSV and JSON for programs. All forms use the same names for the
 * figures. A figure without any events is {@code -} in the text, empty in CSV and null in JSON.
 *
 * @param version version of the program
 * @param recording path of the recording, as it was given
 * @param truth path of the truth
 * @param method name of the method
 * @param preset name of the preset that the parameters started from; empty if the method has no presets
 * @param parameters every parameter of the method by the name of its option; each value is a Number, Boolean or String
 * @param run the evaluation of the recording
 */
public record EvaluationReport(String version, String recording, String truth, String method,
                               String preset, Map<String, Object> parameters, EvaluationRun run) {
    /** The first line of the CSV form, without its end. */
    public static final String CSV_HEADER = "section,of,figure,value";

    private static final int NAME_WIDTH = 46;
    private static final int COLUMN_WIDTH = 12;
    private static final String ALL = "all";

    /** A column of a table, or a row of the convergence table: whose figures, and the figures by name. */
    private record Column(String of, Map<String, Number> figures) {
    }

    private static List<Column> flow(Evaluation evaluation) {
        List<Column> columns = new ArrayList<>();
        columns.add(new Column(ALL, NamedFigures.flow(evaluation.flow())));
        for (FlowFigures figures : evaluation.flowByObject()) {
            columns.add(new Column(Integer.toString(figures.object()), NamedFigures.flow(figures)));
        }
        return columns;
    }

    private static List<Column> segmentation(Evaluation evaluation) {
        List<Column> columns = new ArrayList<>();
        columns.add(new Column(ALL, NamedFigures.segmentation(evaluation.segmentation())));
        for (SegmentationFigures figures : evaluation.segmentationByObject()) {
            columns.add(new Column(Integer.toString(figures.object()), NamedFigures.segmentation(figures)));
        }
        return columns;
    }

    private static List<Column> convergence(Evaluation evaluation) {
        List<Column> rows = new ArrayList<>();
        for (ConvergenceBin bin : evaluation.convergence()) {
            rows.add(new Column(Long.toString(bin.fromUs()), NamedFigures.convergence(bin)));
        }
        return rows;
    }

    /** {@return the report as tables of aligned columns; lines end in LF} */
    public String text() {
        Evaluation evaluation = run.evaluation();
        StringBuilder text = new StringBuilder();
        text.append(recording).append(": ").append(evaluation.events())
                .append(run.labelled() == evaluation.events() ? "" : " of " + run.labelled())
                .append(" events").append(run.labelled() == evaluation.events() ? ", " : " have a truth, ")
                .append(evaluation.eventsCounted()).append(" counted (without the first ")
                .append(NamedFigures.text(100 * evaluation.options().skipFirstShare(), 1)).append(" % of the time)\n")
                .append(method).append(": ")
                .append(NamedFigures.text(run.methodSeconds(), 3)).append(" s, ")
                .append(Math.round(run.eventsPerSecond())).append(" events/s\n");
        table(text, "flow, by object", flow(evaluation));
        table(text, "noise", List.of(new Column(ALL, NamedFigures.noise(evaluation))));
        table(text, "segmentation, by object, in windows of "
                + NamedFigures.text(evaluation.options().windowUs() / 1e3, 0) + " ms", segmentation(evaluation));
        convergenceTable(text, evaluation);
        return text.toString();
    }

    /** Appends a table with one row per figure and one column per object. */
    private static void table(StringBuilder text, String title, List<Column> columns) {
        text.append('\n').append(String.format(Locale.ROOT, "%-" + NAME_WIDTH + "s", title));
        columns.forEach(column -> cell(text, column.of));
        text.append('\n');
        for (String figure : columns.get(0).figures.keySet()) {
            text.append(String.format(Locale.ROOT, "%-" + NAME_WIDTH + "s", "  " + figure.replace('_', ' ')));
            columns.forEach(column -> cell(text, NamedFigures.shortText(column.figures.get(figure))));
            text.append('\n');
        }
    }

    /** Appends a table with one row per bin, without the bins that have no events. */
    private static void convergenceTable(StringBuilder text, Evaluation evaluation) {
        text.append("\nconvergence, by time since an object's appearance\n");
        for (String title : List.of("from ms", "events", "with flow", "magnitude %", "angle deg", "px/s", "error %")) {
            cell(text, title);
        }
        text.append('\n');
        for (Column row : convergence(evaluation)) {
            Map<String, Number> figures = row.figures;
            if (figures.get("events").longValue() > 0) {
                for (String figure : figures.keySet()) {
                    if (!figure.equals("until_ms")) {
                        cell(text, figure.equals("from_ms") ? NamedFigures.text(figures.get(figure), 0)
                                : NamedFigures.shortText(figures.get(figure)));
                    }
                }
                text.append('\n');
            }
        }
    }

    private static void cell(StringBuilder text, String value) {
        text.append(String.format(Locale.ROOT, " %" + (COLUMN_WIDTH - 1) + "s", value));
    }

    /**
     * Writes one line per figure with the columns {@value #CSV_HEADER}. The section is flow, noise, segmentation or
     * convergence. The column "of" holds {@code all}, an object's id, or the beginning of a bin in µs.
     *
     * @param out stream for the text; left open
     * @throws IOException if the text cannot be written
     */
    public void writeCsv(OutputStream out) throws IOException {
        String csv = CSV_HEADER + '\n' + csvLines(run.evaluation(), "");
        out.write(csv.getBytes(StandardCharsets.US_ASCII));
    }

    /**
     * {@return the lines of the CSV form without the header, for a file that holds several evaluations}
     *
     * @param evaluation the figures
     * @param prefix text before each line: the values of further columns on the left, each followed by a comma
     */
    public static String csvLines(Evaluation evaluation, String prefix) {
        StringBuilder csv = new StringBuilder();
        lines(csv, prefix + "flow", flow(evaluation));
        lines(csv, prefix + "noise", List.of(new Column(ALL, NamedFigures.noise(evaluation))));
        lines(csv, prefix + "segmentation", segmentation(evaluation));
        lines(csv, prefix + "convergence", convergence(evaluation));
        return csv.toString();
    }

    private static void lines(StringBuilder csv, String section, List<Column> columns) {
        for (Column column : columns) {
            NamedFigures.appendCsv(csv, section, column.of, column.figures);
        }
    }

    /**
     * Writes the report as a JSON document.
     *
     * @param out stream for the text; left open
     * @throws IOException if the text cannot be written
     */
    public void writeJson(OutputStream out) throws IOException {
        Evaluation evaluation = run.evaluation();
        try (JsonGenerator json = Json.open(out)) {
            json.writeStartObject();
            json.writeStringField("version", version);
            json.writeStringField("recording", recording);
            json.writeStringField("truth", truth);
            json.writeBooleanField("complete", run.damage() == null);
            json.writeStringField("method", method);
            json.writeStringField("preset", preset);
            json.writeFieldName("parameters");
            Json.writeParameters(json, parameters);
            json.writeNumberField("events", evaluation.events());
            json.writeNumberField("events_counted", evaluation.eventsCounted());
            json.writeFieldName("skip_first_share");
            NamedFigures.write(json, evaluation.options().skipFirstShare());
            json.writeNumberField("window_us", evaluation.options().windowUs());
            json.writeFieldName("method_seconds");
            NamedFigures.write(json, run.methodSeconds());
            json.writeFieldName("flow");
            writeColumns(json, flow(evaluation));
            json.writeFieldName("noise");
            NamedFigures.write(json, NamedFigures.noise(evaluation));
            json.writeFieldName("segmentation");
            writeColumns(json, segmentation(evaluation));
            json.writeArrayFieldStart("convergence");
            for (Column bin : convergence(evaluation)) {
                NamedFigures.write(json, bin.figures);
            }
            json.writeEndArray();
            json.writeEndObject();
        }
    }

    /** Writes a JSON object with a field {@code all} and a field for the id of each object. */
    private static void writeColumns(JsonGenerator json, List<Column> columns) throws IOException {
        json.writeStartObject();
        for (Column column : columns) {
            json.writeFieldName(column.of);
            NamedFigures.write(json, column.figures);
        }
        json.writeEndObject();
    }
}
