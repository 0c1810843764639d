package io.github.sofas.report;

import static j2html.TagCreator.text;

import io.github.sofas.export.RunSummary;
import io.github.sofas.flow.Segment;
import io.github.sofas.render.Theme;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.function.IntToDoubleFunction;

/**
 * The text of the page. Plots are SVG inside the page, not pictures of a plot library: they take the colours of a light
 * or dark page, stay sharp on any screen, and tell their values when pointed at.
 */
final class ReportPage {
    private static final int WIDTH = 640;
    private static final int HEIGHT = 200;
    private static final int LEFT = 56;
    private static final int BOTTOM = 30;
    private static final int TOP = 8;
    /** Segments drawn as curves, and as life lines: those with the most events. */
    static final int CURVES = 10;
    private static final int LINES = 40;
    /** Ends of the axis of directions, in degrees; no other axis begins below 0. */
    private static final int HALF_TURN = 180;

    private final RunSummary summary;
    private final String command;
    private final TimeBins bins;
    private final List<SegmentCurve> curves;
    private final long[] directions;
    private final Highlights highlights;
    private final List<HighlightPainter.Thumbnail> thumbnails;
    private final Path clip;
    private final double durationS;
    private final StringBuilder html = new StringBuilder();

    ReportPage(RunSummary summary, String command, TimeBins bins, List<SegmentCurve> curves, long[] directions,
               Highlights highlights, List<HighlightPainter.Thumbnail> thumbnails, Path clip) {
        this.summary = summary;
        this.command = command;
        this.bins = bins;
        this.curves = curves;
        this.directions = directions;
        this.highlights = highlights;
        this.thumbnails = thumbnails;
        this.clip = clip;
        durationS = Math.max(bins.widthS(), bins.used() * bins.widthS());
    }

    void write(OutputStream out) throws IOException {
        String file = Path.of(summary.recording().file()).getFileName().toString();
        html.append("<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
            + "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"><title>")
            .append(escaped(file)).append("</title><style>").append(resource("page.css"));
        colours();
        html.append("</style></head><body>\n<h1>").append(escaped(file)).append("</h1>\n");
        figures();
        if (!thumbnails.isEmpty()) {
            clip(out);
            busiest();
        }
        overTime();
        segments();
        where();
        reproduce();
        html.append("<script>").append(resource("hover.js")).append("</script></body></html>\n");
        flush(out);
    }

    /** What was written so far needs no memory then. */
    private void flush(OutputStream out) throws IOException {
        out.write(html.toString().getBytes(StandardCharsets.UTF_8));
        html.setLength(0);
    }

    /** Those of the segments in the clip, and the same hues darker for a light page. */
    private void colours() {
        for (Theme theme : new Theme[] {Theme.LIGHT, Theme.DARK}) {
            html.append(theme == Theme.DARK ? "@media (prefers-color-scheme: dark) { " : "").append(":root {");
            for (int k = 0; k < CURVES; k++) {
                html.append(String.format(Locale.ROOT, " --c%d: #%06x;", k, theme.segmentColour(k)));
            }
            html.append(theme == Theme.DARK ? " } }\n" : " }\n");
        }
        for (int k = 0; k < CURVES; k++) {
            html.append(String.format(".line.c%1$d { stroke: var(--c%1$d); } .life.c%1$d, .said.c%1$d { fill: "
                + "var(--c%1$d); } .key.c%1$d { border-color: var(--c%1$d); }%n", k));
        }
    }

    private void figures() {
        html.append("<dl class=\"figures\">");
        figure(String.format(Locale.ROOT, "%,d", summary.recording().events()), "events");
        figure(String.format(Locale.ROOT, "%.3f s", summary.recording().durationS()), "of recording");
        figure(String.format(Locale.ROOT, "%,.0f", summary.recording().eventsPerS()), "events a second");
        figure(String.format(Locale.ROOT, "%.1f %%", 100 * summary.shareWithFlow()), "of the events have flow");
        figure(Integer.toString(summary.segments().size()), "segments: " + summary.count(Segment.Fate.ALIVE)
            + " alive at the end, " + summary.count(Segment.Fate.MERGED) + " merged, "
            + summary.count(Segment.Fate.REMOVED) + " removed");
        figure(summary.recording().sensor().toString(), (summary.recording().chip() + " sensor, "
            + summary.recording().format()).strip());
        html.append("</dl>\n");
        if (!summary.recording().complete()) {
            html.append("<p class=\"bad\">The recording is damaged: the page shows what came before.</p>");
        }
        summary.recording().faults().forEach(fault ->
            html.append("<p class=\"bad\">").append(escaped(fault)).append("</p>"));
        html.append('\n');
    }

    private void figure(String value, String name) {
        html.append("<div><dd>").append(escaped(value)).append("</dd><dt>").append(escaped(name))
            .append("</dt></div>");
    }

    private void clip(OutputStream out) throws IOException {
        double fromS = highlights.clipFirst() * Highlights.STEP_US * 1e-6;
        double toS = Math.min(durationS, highlights.clipEnd() * Highlights.STEP_US * 1e-6);
        html.append("<h2>What moves</h2><p>");
        if (highlights.clipIsAll()) {
            html.append("The whole recording");
        } else {
            html.append(String.format(Locale.ROOT, "From %.1f to %.1f s, the %d seconds in which most events have flow",
                fromS, toS, Highlights.CLIP_S));
        }
        html.append(", at the speed of life. Left: the colour is the direction, as on the wheel. Right: a colour "
            + "and a number is one moving structure; the arrow is its velocity.</p>"
            + "<video controls loop muted playsinline src=\"data:video/mp4;base64,");
        flush(out);
        Base64.Encoder encoder = Base64.getEncoder();
        try (InputStream film = Files.newInputStream(clip)) {
            // a multiple of three bytes becomes letters without padding between
            for (byte[] part = film.readNBytes(3 << 14); part.length > 0; part = film.readNBytes(3 << 14)) {
                out.write(encoder.encode(part));
            }
        }
        html.append("\"></video>\n");
    }

    private void busiest() {
        html.append("<h2>Busiest moments</h2><div class=\"grid\">");
        for (HighlightPainter.Thumbnail each : thumbnails) {
            html.append("<figure><img alt=\"flow and segments\" src=\"data:image/png;base64,")
                .append(Base64.getEncoder().encodeToString(each.png())).append("\"><figcaption>")
                .append(String.format(Locale.ROOT, "%.3f s: %,d events in %d ms",
                    each.moment().step() * Highlights.STEP_US * 1e-6, each.moment().events(),
                    Highlights.STEP_US / 1000)).append("</figcaption></figure>");
        }
        html.append("</div>\n");
    }

    private void overTime() {
        html.append("<h2>Over time</h2><div class=\"grid\">");
        double most = 0;
        for (int i = 0; i < bins.used(); i++) {
            most = Math.max(most, bins.rate(i));
        }
        beginPlot("Events a second", 0, most, "events/s");
        curve("all events", "c0", 0, bins.used(), bins::rate, 0, most);
        endPlot();
        beginPlot("Share of the events that have flow", 0, 100, "%");
        curve("with flow", "c1", 0, bins.used(), bins::share, 0, 100);
        endPlot();
        html.append("</div>\n");
    }

    private void segments() {
        List<SegmentCurve> drawn = curves.subList(0, Math.min(CURVES, curves.size()));
        if (drawn.isEmpty()) {
            html.append("<p>No segment was found.</p>\n");
            return;
        }
        double most = 0;
        for (SegmentCurve curve : drawn) {
            for (int i = 0; i < curve.used(); i++) {
                most = Double.isNaN(curve.speed(i)) ? most : Math.max(most, curve.speed(i));
            }
        }
        html.append("<h2>Segments</h2><p>");
        html.append(curves.size() > CURVES ? "The " + CURVES + " with the most events," : "All,");
        html.append(" with their numbers and colours in the clip (darker on a light page):");
        for (int k = 0; k < drawn.size(); k++) {
            html.append(" <span class=\"key c").append(k).append("\">").append(drawn.get(k).id).append("</span>");
        }
        html.append("</p><div class=\"grid\">");
        beginPlot("Speed", 0, most, "px/s");
        for (int k = 0; k < drawn.size(); k++) {
            SegmentCurve curve = drawn.get(k);
            curve("segment " + curve.id, "c" + k, curve.first(), curve.used(), curve::speed, 0, most);
        }
        endPlot();
        beginPlot("Direction: 0 right, 90 up, ±180 left", -HALF_TURN, HALF_TURN, "°");
        for (int k = 0; k < drawn.size(); k++) {
            SegmentCurve curve = drawn.get(k);
            curve("segment " + curve.id, "c" + k, curve.first(), curve.used(), curve::directionDeg, -HALF_TURN,
                HALF_TURN);
        }
        endPlot();
        html.append("</div>\n");
        lifeLines(drawn);
    }

    private void lifeLines(List<SegmentCurve> coloured) {
        List<Segment> shown = summary.segments().stream().sorted(Comparator.comparingLong(Segment::events).reversed())
            .limit(LINES).sorted(Comparator.comparingInt(Segment::id)).toList();
        int row = 14;
        int height = shown.size() * row + BOTTOM;
        html.append("<h3>Life lines</h3>");
        if (summary.segments().size() > LINES) {
            html.append("<p>The ").append(LINES).append(" with the most events of ")
                .append(summary.segments().size()).append(".</p>");
        }
        html.append("<svg class=\"plot lives\" data-to=\"").append(durationS).append("\" viewBox=\"0 0 ").append(WIDTH)
            .append(' ').append(height).append("\" role=\"img\" aria-label=\"life lines of the segments\">");
        for (int i = 0; i < shown.size(); i++) {
            Segment segment = shown.get(i);
            double from = x((segment.firstTimeUs() - summary.recording().firstTimeUs()) * 1e-6);
            double to = x((segment.lastTimeUs() - summary.recording().firstTimeUs()) * 1e-6);
            int place = -1;
            for (int k = 0; k < coloured.size(); k++) {
                place = coloured.get(k).id == segment.id() ? k : place;
            }
            html.append(String.format(Locale.ROOT, "<text x=\"%d\" y=\"%d\" class=\"end\">%d</text>"
                + "<rect x=\"%.1f\" y=\"%d\" width=\"%.1f\" height=\"8\" rx=\"2\" class=\"%s\"><title>", LEFT - 6,
                i * row + 10, segment.id(), from, i * row + 2, Math.max(2, to - from),
                place < 0 ? "life other" : "life c" + place));
            html.append(String.format(Locale.ROOT, "segment %d: %.3f to %.3f s, %,d events, (%.0f, %.0f) px/s, %s",
                segment.id(), (segment.firstTimeUs() - summary.recording().firstTimeUs()) * 1e-6,
                (segment.lastTimeUs() - summary.recording().firstTimeUs()) * 1e-6, segment.events(),
                segment.vxPxPerS(), segment.vyPxPerS(), segment.fate() == Segment.Fate.MERGED
                    ? "merged into " + segment.mergedInto() : segment.fate().name().toLowerCase(Locale.ROOT)))
                .append("</title></rect>");
        }
        timeAxis(height - BOTTOM);
        html.append("</svg>\n");
    }

    private void where() {
        long most = 1;
        long all = 0;
        for (long each : directions) {
            most = Math.max(most, each);
            all += each;
        }
        if (all == 0) {
            return;
        }
        html.append("<h2>Where it moves</h2><p>Share of the events with flow in each direction.</p>"
            + "<svg class=\"polar\" viewBox=\"-130 -120 260 240\" role=\"img\" aria-label=\"directions of flow\">"
            + "<circle r=\"100\"/><circle r=\"50\"/>");
        for (int d = 0; d < directions.length; d++) {
            double r = 100.0 * directions[d] / most;
            double half = Math.PI / directions.length;
            double at = 2 * d * half;
            html.append(String.format(Locale.ROOT, "<path d=\"M0 0L%.2f %.2fL%.2f %.2fZ\"><title>%.0f°: %.1f %%"
                + "</title></path>", r * Math.cos(at - half), -r * Math.sin(at - half), r * Math.cos(at + half),
                -r * Math.sin(at + half), Math.toDegrees(at), 100.0 * directions[d] / all));
        }
        html.append(String.format(Locale.ROOT, "<text x=\"104\" y=\"4\">right</text><text x=\"0\" y=\"-105\" "
            + "class=\"middle\">up</text><text x=\"-104\" y=\"4\" class=\"end\">left</text><text x=\"0\" y=\"115\" "
            + "class=\"middle\">down</text><text x=\"74\" y=\"-74\">%.0f %%</text></svg>%n", 100.0 * most / all));
    }

    private void reproduce() {
        html.append("<h2>How to make this again</h2><pre>").append(escaped(command)).append("</pre><p>SOFAS ")
            .append(escaped(summary.version())).append(", method ").append(escaped(summary.method()));
        html.append(summary.preset().isEmpty() ? "" : ", preset " + escaped(summary.preset()));
        html.append("</p><details><summary>All parameters</summary><table>");
        summary.parameters().forEach((name, value) -> html.append("<tr><td>--").append(escaped(name))
            .append("</td><td>").append(escaped(value.toString())).append("</td></tr>"));
        html.append("</table></details>\n");
    }

    private void beginPlot(String title, double from, double to, String unit) {
        html.append("<figure><figcaption>").append(escaped(title)).append(", ").append(escaped(unit))
            .append("</figcaption><svg class=\"plot\" data-to=\"").append(durationS)
            .append("\" data-low=\"").append(from).append("\" data-high=\"").append(to).append("\" data-unit=\"")
            .append(unit).append("\" viewBox=\"0 0 ")
            .append(WIDTH).append(' ').append(HEIGHT).append("\" role=\"img\" aria-label=\"").append(escaped(title))
            .append("\">");
        for (int i = 0; i <= 4; i++) {
            double value = from + (to - from) * i / 4;
            double y = y(value, from, to);
            html.append(String.format(Locale.ROOT, "<path class=\"rule\" d=\"M%d %.1fH%d\"/><text x=\"%d\" "
                + "y=\"%.1f\" class=\"end\">%s</text>", LEFT, y, WIDTH, LEFT - 6, y + 4, label(value)));
        }
        timeAxis(HEIGHT - BOTTOM);
    }

    private static String label(double value) {
        double magnitude = Math.abs(value);
        return magnitude >= 10_000 ? String.format(Locale.ROOT, "%.0fk", value / 1000)
            : magnitude >= 10 || value == 0 ? String.format(Locale.ROOT, "%.0f", value)
            : String.format(Locale.ROOT, "%.1f", value);
    }

    private void timeAxis(int y) {
        for (int i = 0; i <= 4; i++) {
            double s = durationS * i / 4;
            html.append(String.format(Locale.ROOT, "<text x=\"%.1f\" y=\"%d\" class=\"%s\">%.2f%s</text>", x(s), y + 18,
                i == 0 ? "" : i == 4 ? "end" : "middle", s, i == 4 ? " s" : ""));
        }
    }

    private void endPlot() {
        html.append("</svg></figure>");
    }

    private void curve(String name, String style, int first, int count, IntToDoubleFunction value, double from,
                       double to) {
        html.append("<path class=\"line ").append(style).append("\" d=\"");
        boolean pen = false;
        double last = 0;
        for (int i = 0; i < count; i++) {
            double v = value.applyAsDouble(i);
            if (Double.isNaN(v)) {
                pen = false;
                continue;
            }
            // from -180 to 180 degrees is no way
            pen &= from != -HALF_TURN || Math.abs(v - last) <= HALF_TURN;
            last = v;
            // a point alone is a line of no length, which round ends make a dot
            html.append(String.format(Locale.ROOT, pen ? "L%.1f %.1f" : "M%1$.1f %2$.1fL%1$.1f %2$.1f",
                x((first + i + 0.5) * bins.widthS()), y(v, from, to)));
            pen = true;
        }
        html.append("\"><title>").append(escaped(name)).append("</title></path>");
    }

    private double x(double s) {
        return LEFT + (WIDTH - LEFT) * Math.max(0, Math.min(1, s / durationS));
    }

    private static double y(double value, double from, double to) {
        return HEIGHT - BOTTOM - (HEIGHT - BOTTOM - TOP) * (to > from ? (value - from) / (to - from) : 0);
    }

    private static String escaped(String text) {
        return text(text).render();
    }

    private static String resource(String name) {
        try (InputStream in = ReportPage.class.getResourceAsStream(name)) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
