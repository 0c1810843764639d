package io.github.sofas.experiments;

import io.github.sofas.evaluate.EvaluationReport;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Locale;

/**
 * The files that the experiments write: one page for people, and every number as CSV. Numbers have a decimal point, a
 * value that does not exist is empty, and lines end in LF.
 */
public enum ExperimentFiles {
    /** The page, which needs no other file and no network. */
    REPORT("experiments.html"),
    /** The method in four pictures. */
    METHOD("method.png"),
    /** Every figure of every method in every setting. */
    FIGURES("figures.csv"),
    /** What the default preset should reach, and what it reaches. */
    GOALS("goals.csv"),
    /** Histograms of the errors. */
    HISTOGRAMS("histograms.csv"),
    /** Every curve of the page. */
    CURVES("curves.csv"),
    /** The default preset in each random and each textured scene. */
    RANDOM_SCENES("random-scenes.csv"),
    /** The metric maps. */
    METRIC_MAPS("metric-maps.csv");

    private final String fileName;

    ExperimentFiles(String fileName) {
        this.fileName = fileName;
    }

    /** Name of the file in the results folder. */
    public String fileName() {
        return fileName;
    }

    /**
     * Writes the file and leaves the stream open.
     *
     * @param version version of the program
     * @throws IOException if the file cannot be written
     */
    public void write(Experiments experiments, String version, OutputStream out) throws IOException {
        String text;
        switch (this) {
            case METHOD:
                out.write(experiments.methodPicture().light());
                return;
            case REPORT:
                text = new ExperimentReport(experiments, version).page();
                break;
            case FIGURES:
                text = figures(experiments);
                break;
            case GOALS:
                text = goals(experiments);
                break;
            case HISTOGRAMS:
                text = histograms(experiments);
                break;
            case CURVES:
                text = curves(experiments);
                break;
            case RANDOM_SCENES:
                text = experiments.randomScenes().csv();
                break;
            default:
                text = metricMaps(experiments);
        }
        out.write(text.getBytes(StandardCharsets.UTF_8));
    }

    private static String figures(Experiments experiments) {
        StringBuilder csv = new StringBuilder("setting,method," + EvaluationReport.CSV_HEADER + "\n");
        for (Setting setting : Setting.ALL) {
            for (ComparedMethod method : ComparedMethod.values()) {
                csv.append(EvaluationReport.csvLines(experiments.trial(setting, method).evaluation(),
                    setting.id() + "," + method.id() + ","));
            }
        }
        return csv.toString();
    }

    private static String goals(Experiments experiments) {
        StringBuilder csv = new StringBuilder("scene,figure,goal,reached,met\n");
        experiments.checksByScene().forEach((scene, checks) -> checks.forEach(check -> csv
            .append(quoted(scene)).append(',').append(quoted(check.figure())).append(',')
            .append(quoted(check.goal())).append(',').append(quoted(check.reached())).append(',')
            .append(check.met()).append('\n')));
        return csv.toString();
    }

    private static String histograms(Experiments experiments) {
        StringBuilder csv = new StringBuilder("setting,method,error,from,until,events\n");
        for (Setting setting : Setting.ALL) {
            for (ComparedMethod method : ComparedMethod.values()) {
                Trial trial = experiments.trial(setting, method);
                String key = setting.id() + "," + method.id();
                histogram(csv, key + ",magnitude_percent,", trial.magnitudeError());
                histogram(csv, key + ",direction_deg,", trial.directionError());
            }
        }
        return csv.toString();
    }

    private static void histogram(StringBuilder csv, String key, Histogram histogram) {
        csv.append(key).append(',').append(number(-histogram.limit())).append(',').append(histogram.below())
            .append('\n');
        for (int b = 0; b < histogram.counts().length; b++) {
            csv.append(key).append(number(histogram.from(b))).append(',')
                .append(number(histogram.from(b) + histogram.width())).append(',').append(histogram.counts()[b])
                .append('\n');
        }
        csv.append(key).append(number(histogram.limit())).append(",,").append(histogram.above()).append('\n');
    }

    private static String curves(Experiments experiments) {
        StringBuilder csv = new StringBuilder("plot,line,x,y\n");
        for (Plot plot : Plots.all(experiments)) {
            for (Plot.Line line : plot.lines()) {
                for (int i = 0; i < line.x().length; i++) {
                    csv.append(plot.id()).append(',').append(quoted(line.name())).append(',')
                        .append(number(line.x()[i])).append(',').append(number(line.y()[i])).append('\n');
                }
            }
        }
        return csv.toString();
    }

    private static String metricMaps(Experiments experiments) {
        StringBuilder csv = new StringBuilder("objects,vx_px_per_s,vy_px_per_s,metric\n");
        metricMap(csv, "one", experiments.oneObject());
        metricMap(csv, "two", experiments.twoObjects());
        return csv.toString();
    }

    private static void metricMap(StringBuilder csv, String objects, MetricMap map) {
        int n = map.n();
        for (int row = 0; row < n; row++) {
            String vy = number(MetricMap.velocity(row, n));
            for (int column = 0; column < n; column++) {
                csv.append(objects).append(',').append(number(MetricMap.velocity(column, n))).append(',').append(vy)
                    .append(',').append(map.metrics()[row][column]).append('\n');
            }
        }
    }

    private static String number(double value) {
        return Double.isNaN(value) ? "" : String.format(Locale.ROOT, "%.3f", value);
    }

    /** Quotes a text as RFC 4180 requires. */
    private static String quoted(String text) {
        return text.contains(",") || text.contains("\"") ? "\"" + text.replace("\"", "\"\"") + "\"" : text;
    }
}
