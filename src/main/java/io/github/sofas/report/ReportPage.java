package io.github.sofas.report;

import static j2html.TagCreator.body;
import static j2html.TagCreator.dd;
import static j2html.TagCreator.details;
import static j2html.TagCreator.div;
import static j2html.TagCreator.dl;
import static j2html.TagCreator.dt;
import static j2html.TagCreator.each;
import static j2html.TagCreator.figcaption;
import static j2html.TagCreator.figure;
import static j2html.TagCreator.h1;
import static j2html.TagCreator.h2;
import static j2html.TagCreator.h3;
import static j2html.TagCreator.head;
import static j2html.TagCreator.html;
import static j2html.TagCreator.img;
import static j2html.TagCreator.join;
import static j2html.TagCreator.meta;
import static j2html.TagCreator.p;
import static j2html.TagCreator.pre;
import static j2html.TagCreator.rawHtml;
import static j2html.TagCreator.script;
import static j2html.TagCreator.span;
import static j2html.TagCreator.style;
import static j2html.TagCreator.summary;
import static j2html.TagCreator.table;
import static j2html.TagCreator.tbody;
import static j2html.TagCreator.td;
import static j2html.TagCreator.text;
import static j2html.TagCreator.th;
import static j2html.TagCreator.thead;
import static j2html.TagCreator.title;
import static j2html.TagCreator.tr;
import static j2html.TagCreator.video;

import io.github.sofas.export.RunSummary;
import io.github.sofas.flow.Segment;
import io.github.sofas.render.Theme;
import j2html.TagCreator;
import j2html.tags.DomContent;
import j2html.tags.specialized.HtmlTag;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;

/**
 * Composes the page from the figures of a run and writes it as HTML. All drawings, pictures and the clip are in the
 * page itself.
 */
final class ReportPage {
    /** Most segments drawn as curves, and most drawn as life lines: those with the most events. */
    static final int CURVES = 10;
    private static final int LINES = 40;
    /** Placeholder of the film, which is written from its file at the end, so that memory never holds it. */
    private static final String FILM = "@film@";

    private final RunSummary summary;
    private final String command;
    private final TimeBins bins;
    private final List<SegmentCurve> curves;
    private final long[] directions;
    private final Highlights highlights;
    private final List<HighlightPainter.Thumbnail> thumbnails;
    private final List<byte[]> legends;
    private final List<DomContent> sharpness;
    private final Path clip;
    private final double durationS;

    ReportPage(RunSummary summary, String command, TimeBins bins, List<SegmentCurve> curves, long[] directions,
               Highlights highlights, List<HighlightPainter.Thumbnail> thumbnails, List<byte[]> legends,
               List<DomContent> sharpness, Path clip) {
        this.summary = summary;
        this.command = command;
        this.bins = bins;
        this.curves = curves;
        this.directions = directions;
        this.highlights = highlights;
        this.thumbnails = thumbnails;
        this.legends = legends;
        this.sharpness = sharpness;
        this.clip = clip;
        durationS = Math.max(bins.widthS(), bins.used() * bins.widthS());
    }

    void write(OutputStream out) throws IOException {
        String page = TagCreator.document(page());
        int film = page.indexOf(FILM);
        if (film < 0) {
            out.write(page.getBytes(StandardCharsets.UTF_8));
            return;
        }
        out.write(page.substring(0, film).getBytes(StandardCharsets.UTF_8));
        writeFilm(out);
        out.write(page.substring(film + FILM.length()).getBytes(StandardCharsets.UTF_8));
    }

    private void writeFilm(OutputStream out) throws IOException {
        Base64.Encoder encoder = Base64.getEncoder();
        try (InputStream film = Files.newInputStream(clip)) {
            // parts of a multiple of three bytes need no padding between them
            for (byte[] part = film.readNBytes(3 << 14); part.length > 0; part = film.readNBytes(3 << 14)) {
                out.write(encoder.encode(part));
            }
        }
    }

    private HtmlTag page() {
        String file = Path.of(summary.recording().file()).getFileName().toString();
        List<DomContent> parts = new ArrayList<>();
        parts.add(h1(file));
        parts.addAll(figures());
        if (!thumbnails.isEmpty()) {
            parts.addAll(clip());
            parts.addAll(busiest());
        }
        parts.addAll(sharpness);
        parts.addAll(overTime());
        parts.addAll(segments());
        parts.addAll(where());
        parts.addAll(reproduce());
        return html(
            head(
                meta().withCharset("utf-8"),
                meta().withName("viewport").withContent("width=device-width, initial-scale=1"),
                title(file),
                style(rawHtml(resource("page.css") + colours()))),
            body(each(parts, part -> part), script(rawHtml(resource("hover.js"))))).withLang("en");
    }

    /**
     * Style rules for the colours of the segments: on a dark page those of the clip, on a light page darker colours of
     * the same hues.
     */
    private static String colours() {
        StringBuilder css = new StringBuilder();
        for (Theme theme : new Theme[] {Theme.LIGHT, Theme.DARK}) {
            css.append(theme == Theme.DARK ? "@media (prefers-color-scheme: dark) { " : "").append(":root {");
            for (int k = 0; k < CURVES; k++) {
                css.append(String.format(Locale.ROOT, " --c%d: #%06x;", k, theme.segmentColour(k)));
            }
            css.append(theme == Theme.DARK ? " } }\n" : " }\n");
        }
        for (int k = 0; k < CURVES; k++) {
            css.append(String.format(Locale.ROOT, ".line.c%1$d { stroke: var(--c%1$d); } .life.c%1$d, .said.c%1$d { "
                + "fill: var(--c%1$d); } .key.c%1$d { border-color: var(--c%1$d); }%n", k));
        }
        return css.toString();
    }

    private List<DomContent> figures() {
        List<DomContent> parts = new ArrayList<>();
        parts.add(dl(
            value(String.format(Locale.ROOT, "%,d", summary.recording().events()), "events"),
            value(String.format(Locale.ROOT, "%.3f s", summary.recording().durationS()), "of recording"),
            value(String.format(Locale.ROOT, "%,.0f", summary.recording().eventsPerS()), "events per second"),
            value(String.format(Locale.ROOT, "%.1f %%", 100 * summary.shareWithFlow()), "of the events have flow"),
            value(Long.toString(summary.countLarge()), "segments of 1 % of the events with flow or more; in all "
                + summary.count(Segment.Fate.ALIVE) + " alive at the end, " + summary.count(Segment.Fate.MERGED)
                + " merged, " + summary.count(Segment.Fate.REMOVED) + " removed"),
            value(summary.recording().sensor().toString(), (summary.recording().chip() + " sensor, "
                + summary.recording().format()).strip())).withClass("figures"));
        if (!summary.withoutFlow().isEmpty()) {
            parts.add(p("Most events found no flow: " + summary.withoutFlow() + ".").withClass("bad"));
        }
        if (!summary.recording().complete()) {
            parts.add(p("The recording is damaged: the page shows what came before.").withClass("bad"));
        }
        summary.recording().notes().forEach(note -> parts.add(p(note).withClass("note")));
        summary.recording().faults().forEach(fault -> parts.add(p(fault).withClass("bad")));
        return parts;
    }

    private static DomContent value(String value, String name) {
        return div(dd(value), dt(name));
    }

    private List<DomContent> clip() {
        double fromS = highlights.clipFirst() * Highlights.STEP_US * 1e-6;
        double toS = Math.min(durationS, highlights.clipEnd() * Highlights.STEP_US * 1e-6);
        String when = highlights.clipIsAll() ? "The whole recording" : String.format(Locale.ROOT,
            "From %.1f to %.1f s, the %d seconds in which most events have flow", fromS, toS, Highlights.CLIP_S);
        return List.of(h2("What moves"), p(when + ", in real time. Left: the colour is the direction of the flow. "
            + "Right: one colour and number per moving structure; arrows are velocities."),
            video().withCondControls(true).withCondLoop(true).withCondMuted(true).attr("playsinline")
                .attr("poster", png(poster())).withSrc("data:video/mp4;base64," + FILM),
            // the legends come again below the clip, because its controls cover those in its pictures
            div(img().withAlt("Colours of directions: the wheel shows where each colour moves; grey: no flow")
                    .withSrc(png(legends.get(0))),
                img().withAlt("A colour and a number: one moving structure; the bar is an arrow of the full speed")
                    .withSrc(png(legends.get(1)))).withClass("legends"));
    }

    /** The picture shown before the clip plays: the busiest moment. The clip itself begins with an empty picture. */
    private byte[] poster() {
        return thumbnails.stream().max(Comparator.comparingLong(each -> each.moment().events())).orElseThrow().png();
    }

    private static String png(byte[] bytes) {
        return "data:image/png;base64," + Base64.getEncoder().encodeToString(bytes);
    }

    private List<DomContent> busiest() {
        return List.of(h2("Busiest moments"), div(each(thumbnails, each -> figure(
            img().withAlt("flow and segments")
                .withSrc(png(each.png())),
            figcaption(String.format(Locale.ROOT, "%.3f s: %,d events in %d ms",
                each.moment().step() * Highlights.STEP_US * 1e-6, each.moment().events(),
                Highlights.STEP_US / 1000))))).withClass("grid"));
    }

    private TimePlot plot(String title, double low, double high, String unit) {
        return new TimePlot(title, durationS, bins.widthS(), low, high, unit);
    }

    private List<DomContent> overTime() {
        double most = IntStream.range(0, bins.used()).mapToDouble(bins::rate).max().orElse(0);
        return List.of(h2("Over time"), div(
            plot("Events per second", 0, most, "events/s")
                .curve("all events", "c0", 0, bins.used(), bins::rate).figure(),
            plot("Share of the events that have flow", 0, 100, "%")
                .curve("with flow", "c1", 0, bins.used(), bins::share).figure()).withClass("grid"));
    }

    private List<DomContent> segments() {
        List<SegmentCurve> drawn = curves.subList(0, Math.min(CURVES, curves.size()));
        if (drawn.isEmpty()) {
            return List.of(p("No segment was found."));
        }
        double most = 0;
        for (SegmentCurve curve : drawn) {
            for (int i = 0; i < curve.used(); i++) {
                most = Double.isNaN(curve.speed(i)) ? most : Math.max(most, curve.speed(i));
            }
        }
        TimePlot speed = plot("Speed", 0, most, "px/s");
        TimePlot direction = plot("Direction: 0 right, 90 down, ±180 left", -TimePlot.HALF_TURN, TimePlot.HALF_TURN,
            "°");
        for (int k = 0; k < drawn.size(); k++) {
            SegmentCurve curve = drawn.get(k);
            speed.curve("segment " + curve.id, "c" + k, curve.first(), curve.used(), curve::speed);
            direction.curve("segment " + curve.id, "c" + k, curve.first(), curve.used(), curve::directionDeg);
        }
        List<DomContent> parts = new ArrayList<>();
        parts.add(h2("Segments"));
        List<Object> words = new ArrayList<>();
        words.add((curves.size() > CURVES ? "The " + CURVES + " with the most events," : "All,")
            + " with their numbers and colours in the clip (darker on a light page):");
        for (int k = 0; k < drawn.size(); k++) {
            words.add(span(Integer.toString(drawn.get(k).id)).withClass("key c" + k));
        }
        parts.add(p(join(words.toArray())));
        parts.add(div(speed.figure(), direction.figure()).withClass("grid"));
        parts.addAll(lifeLines(drawn));
        return parts;
    }

    private List<DomContent> lifeLines(List<SegmentCurve> coloured) {
        List<Segment> shown = summary.segments().stream().sorted(Comparator.comparingLong(Segment::events).reversed())
            .limit(LINES).sorted(Comparator.comparingInt(Segment::id)).toList();
        LifeLines lines = new LifeLines(durationS, shown.size());
        for (Segment segment : shown) {
            double fromS = (segment.firstTimeUs() - summary.recording().firstTimeUs()) * 1e-6;
            double toS = (segment.lastTimeUs() - summary.recording().firstTimeUs()) * 1e-6;
            int place = -1;
            for (int k = 0; k < coloured.size(); k++) {
                place = coloured.get(k).id == segment.id() ? k : place;
            }
            lines.add(segment.id(), fromS, toS, place < 0 ? "other" : "c" + place, String.format(Locale.ROOT,
                "segment %d: %.3f to %.3f s, %,d events, (%s, %s) px/s, %s", segment.id(), fromS, toS,
                segment.events(), velocity(segment.vxPxPerS()), velocity(segment.vyPxPerS()), fate(segment)));
        }
        int all = summary.segments().size();
        return List.of(h3("Life lines"),
            text(all > LINES ? "The " + LINES + " with the most events of " + all + "." : ""), lines.svg(),
            h3("Table"), div(tableOf(shown)).withClass("scroll"));
    }

    /** A table of the segments with figures from the segments file. */
    private DomContent tableOf(List<Segment> shown) {
        return table(thead(tr(each(List.of("segment", "from, s", "to, s", "events", "right, px/s", "down, px/s",
            "became"), name -> th(name)))), tbody(each(shown, segment -> tr(td(Integer.toString(segment.id())),
            td(seconds(segment.firstTimeUs())), td(seconds(segment.lastTimeUs())),
            td(String.format(Locale.ROOT, "%,d", segment.events())), td(velocity(segment.vxPxPerS())),
            td(velocity(segment.vyPxPerS())), td(fate(segment))))))
            .withClass("figures-table");
    }

    private static String fate(Segment segment) {
        return segment.fate() == Segment.Fate.MERGED ? "merged into " + segment.mergedInto()
            : segment.fate().name().toLowerCase(Locale.ROOT);
    }

    private String seconds(long timeUs) {
        return String.format(Locale.ROOT, "%.3f", (timeUs - summary.recording().firstTimeUs()) * 1e-6);
    }

    /** A velocity, rounded, and never "-0". */
    private static String velocity(double pxPerS) {
        return Long.toString(Math.round(pxPerS));
    }

    private List<DomContent> where() {
        DirectionPlot plot = new DirectionPlot(directions);
        return plot.isEmpty() ? List.of() : List.of(h2("Where it moves"),
            p("Share of the events with flow in each direction."), plot.svg());
    }

    private List<DomContent> reproduce() {
        return List.of(h2("How to reproduce this"), pre(command),
            p("SOFAS " + summary.version() + ", method " + summary.method()
                + (summary.preset().isEmpty() ? "" : ", preset " + summary.preset())),
            details(summary("All parameters"), table(each(summary.parameters(), (name, value) ->
                tr(td(name), td(value.toString()))))));
    }

    private static String resource(String name) {
        try (InputStream in = ReportPage.class.getResourceAsStream(name)) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
