package io.github.sofas.evaluate;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * An evaluation for people and for programs. All forms name the figures alike; a figure that there are no events for is
 * {@code -} in the text, empty in CSV and null in JSON.
 *
 * @param version of the program
 * @param recording path of the recording, as it was given
 * @param truth path of its truth
 * @param method name of the method
 * @param parameters every parameter of the method by its option's name: a Number, Boolean or String each
 * @param run what came of it
 */
public record EvaluationReport(String version, String recording, String truth, String method,
                               Map<String, Object> parameters, EvaluationRun run) {
    /** The first line of the CSV form, without its end. */
    public static final String CSV_HEADER = "section,of,figure,value";

    private static final int NAME_WIDTH = 46;
    private static final int COLUMN_WIDTH = 12;
    private static final String ALL = "all";

    /** A figure of a column of the tables. */
    private record Column(String of, Map<String, Number> figures) {
    }

    private List<Column> flow() {
        List<Column> columns = new ArrayList<>();
        columns.add(new Column(ALL, NamedFigures.flow(run.evaluation().flow())));
        for (FlowFigures figures : run.evaluation().flowByObject()) {
            columns.add(new Column(Integer.toString(figures.object()), NamedFigures.flow(figures)));
        }
        return columns;
    }

    private List<Column> segmentation() {
        List<Column> columns = new ArrayList<>();
        columns.add(new Column(ALL, NamedFigures.segmentation(run.evaluation().segmentation())));
        for (SegmentationFigures figures : run.evaluation().segmentationByObject()) {
            columns.add(new Column(Integer.toString(figures.object()), NamedFigures.segmentation(figures)));
        }
        return columns;
    }

    private List<Column> convergence() {
        List<Column> rows = new ArrayList<>();
        for (ConvergenceBin bin : run.evaluation().convergence()) {
            rows.add(new Column(Long.toString(bin.fromUs()), NamedFigures.convergence(bin)));
        }
        return rows;
    }

    /** Tables of aligned columns; lines end in LF. */
    public String text() {
        Evaluation evaluation = run.evaluation();
        StringBuilder text = new StringBuilder();
        text.append(recording).append(": ").append(evaluation.events()).append(" events, ")
                .append(evaluation.eventsCounted()).append(" counted (without the first ")
                .append(NamedFigures.text(100 * evaluation.options().skipFirstShare(), 1)).append(" % of the time)\n")
                .append(method).append(": ")
                .append(NamedFigures.text(run.methodSeconds(), 3)).append(" s, ")
                .append(Math.round(run.eventsPerSecond())).append(" events/s\n");
        table(text, "flow, by object", flow());
        table(text, "noise", List.of(new Column(ALL, NamedFigures.noise(evaluation))));
        table(text, "segmentation, by object, in windows of "
                + NamedFigures.text(evaluation.options().windowUs() / 1e3, 0) + " ms", segmentation());
        convergenceTable(text);
        return text.toString();
    }

    /** A row a figure, a column an object. */
    private static void table(StringBuilder text, String title, List<Column> columns) {
        text.append('\n').append(String.format(Locale.ROOT, "%-" + NAME_WIDTH + "s", title));
        columns.forEach(column -> cell(text, column.of));
        text.append('\n');
        for (String figure : columns.get(0).figures.keySet()) {
            text.append(String.format(Locale.ROOT, "%-" + NAME_WIDTH + "s", "  " + figure.replace('_', ' ')));
            columns.forEach(column -> cell(text, shortText(column.figures.get(figure))));
            text.append('\n');
        }
    }

    /** A row a bin; only as far as there are events. */
    private void convergenceTable(StringBuilder text) {
        text.append("\nconvergence, by time since an object's appearance\n");
        for (String title : List.of("from ms", "events", "with flow", "magnitude %", "angle deg", "px/s", "error %")) {
            cell(text, title);
        }
        text.append('\n');
        for (Column row : convergence()) {
            Map<String, Number> figures = row.figures;
            if (figures.get("events").longValue() > 0) {
                for (String figure : figures.keySet()) {
                    if (!figure.equals("until_ms")) {
                        cell(text, figure.equals("from_ms") ? NamedFigures.text(figures.get(figure), 0)
                                : shortText(figures.get(figure)));
                    }
                }
                text.append('\n');
            }
        }
    }

    private static void cell(StringBuilder text, String value) {
        text.append(String.format(Locale.ROOT, " %" + (COLUMN_WIDTH - 1) + "s", value));
    }

    private static String shortText(Number value) {
        return value == null ? "-" : NamedFigures.text(value, 3);
    }

    /**
     * Writes one line a figure, {@value #CSV_HEADER}: section is flow, noise, segmentation or convergence; of is
     * {@code all}, an object's id, or a bin's begin in µs. Leaves the stream open.
     *
     * @throws IOException where it cannot be written
     */
    public void writeCsv(OutputStream out) throws IOException {
        StringBuilder csv = new StringBuilder(CSV_HEADER).append('\n');
        lines(csv, "flow", flow());
        lines(csv, "noise", List.of(new Column(ALL, NamedFigures.noise(run.evaluation()))));
        lines(csv, "segmentation", segmentation());
        lines(csv, "convergence", convergence());
        out.write(csv.toString().getBytes(StandardCharsets.US_ASCII));
    }

    private static void lines(StringBuilder csv, String section, List<Column> columns) {
        for (Column column : columns) {
            column.figures.forEach((figure, value) -> csv.append(section).append(',').append(column.of).append(',')
                    .append(figure).append(',').append(value == null ? "" : NamedFigures.text(value)).append('\n'));
        }
    }
}
