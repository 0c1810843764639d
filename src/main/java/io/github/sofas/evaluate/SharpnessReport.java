package io.github.sofas.evaluate;

import com.fasterxml.jackson.core.JsonGenerator;
import io.github.sofas.export.Json;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * Report of how sharp a method's flow makes the picture of a recording, as text for people and as CSV and JSON for
 * programs. All forms use the same names for the figures. A gain over a translation that sharpens nothing is {@code -}
 * in the text, empty in CSV and null in JSON.
 *
 * @param version version of the program
 * @param recording path of the recording, as it was given
 * @param method name of the method
 * @param preset name of the preset that the parameters started from; empty if the method has no presets
 * @param parameters every parameter of the method by the name of its option; each value is a Number, Boolean or String
 * @param run the measurement of the recording
 */
public record SharpnessReport(String version, String recording, String method, String preset,
                              Map<String, Object> parameters, SharpnessRun run) {
    private static final int COLUMN_WIDTH = 12;

    /** {@return lines of totals, then a table of the windows; lines end in LF} */
    public String text() {
        Sharpness sharpness = run.sharpness();
        StringBuilder text = new StringBuilder();
        text.append(String.format(Locale.ROOT, "%s: %d events, %d windows, %.1f %% with flow\n", recording,
            sharpness.events(), sharpness.windows().size(), 100 * sharpness.shareWithFlow()));
        text.append(String.format(Locale.ROOT, "%s: %.3f s, %d events/s\n", method, run.methodSeconds(),
            Math.round(run.eventsPerSecond())));
        text.append(String.format(Locale.ROOT,
            "sharpness %.3f, best single translation %.3f, gain %s\n\n", sharpness.sharpness(),
            sharpness.translationSharpness(), gain(sharpness.translationSharpness(), sharpness.sharpness())));
        for (String title : List.of("from ms", "until ms", "events", "with flow", "sharpness", "translation", "gain",
                "vx px/s", "vy px/s")) {
            cell(text, title);
        }
        text.append('\n');
        long startUs = sharpness.windows().isEmpty() ? 0 : sharpness.windows().get(0).fromUs();
        for (SharpnessWindow window : sharpness.windows()) {
            cell(text, number(1, (window.fromUs() - startUs) * 1e-3));
            cell(text, number(1, (window.untilUs() - startUs) * 1e-3));
            cell(text, Long.toString(window.events()));
            cell(text, number(3, window.shareWithFlow()));
            cell(text, number(3, window.sharpness()));
            cell(text, number(3, window.translationSharpness()));
            cell(text, gain(window.translationSharpness(), window.sharpness()));
            cell(text, number(1, window.translationVxPxPerS()));
            cell(text, number(1, window.translationVyPxPerS()));
            text.append('\n');
        }
        return text.toString();
    }

    private static String gain(double translationSharpness, double sharpness) {
        return Sharpness.hasGain(translationSharpness)
            ? number(2, Sharpness.gain(sharpness, translationSharpness)) : "-";
    }

    private static String number(int decimals, double value) {
        return NamedFigures.text((Double) value, decimals);
    }

    private static void cell(StringBuilder text, String value) {
        text.append(String.format(Locale.ROOT, " %" + (COLUMN_WIDTH - 1) + "s", value));
    }

    /**
     * Writes one line per figure with the columns {@value EvaluationReport#CSV_HEADER}. The section is sharpness. The
     * column "of" holds {@code all} or the number of a window, from 0.
     *
     * @param out stream for the text; left open
     * @throws IOException if the text cannot be written
     */
    public void writeCsv(OutputStream out) throws IOException {
        StringBuilder csv = new StringBuilder(EvaluationReport.CSV_HEADER).append('\n');
        NamedFigures.appendCsv(csv, "sharpness", "all", NamedFigures.sharpness(run.sharpness()));
        List<SharpnessWindow> windows = run.sharpness().windows();
        for (int i = 0; i < windows.size(); i++) {
            NamedFigures.appendCsv(csv, "sharpness", Integer.toString(i), NamedFigures.sharpness(windows.get(i)));
        }
        out.write(csv.toString().getBytes(StandardCharsets.US_ASCII));
    }

    /**
     * Writes the report as a JSON document.
     *
     * @param out stream for the text; left open
     * @throws IOException if the text cannot be written
     */
    public void writeJson(OutputStream out) throws IOException {
        try (JsonGenerator json = Json.open(out)) {
            json.writeStartObject();
            json.writeStringField("version", version);
            json.writeStringField("recording", recording);
            json.writeBooleanField("complete", run.damage() == null);
            json.writeStringField("method", method);
            json.writeStringField("preset", preset);
            json.writeFieldName("parameters");
            Json.writeParameters(json, parameters);
            json.writeFieldName("method_seconds");
            NamedFigures.write(json, run.methodSeconds());
            json.writeObjectFieldStart("sharpness");
            json.writeFieldName("all");
            NamedFigures.write(json, NamedFigures.sharpness(run.sharpness()));
            json.writeArrayFieldStart("windows");
            for (SharpnessWindow window : run.sharpness().windows()) {
                NamedFigures.write(json, NamedFigures.sharpness(window));
            }
            json.writeEndArray();
            json.writeEndObject();
            json.writeEndObject();
        }
    }
}
