package io.github.sofas.experiments;

import static j2html.TagCreator.a;
import static j2html.TagCreator.body;
import static j2html.TagCreator.code;
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
import static j2html.TagCreator.li;
import static j2html.TagCreator.meta;
import static j2html.TagCreator.nav;
import static j2html.TagCreator.ol;
import static j2html.TagCreator.p;
import static j2html.TagCreator.rawHtml;
import static j2html.TagCreator.source;
import static j2html.TagCreator.span;
import static j2html.TagCreator.style;
import static j2html.TagCreator.summary;
import static j2html.TagCreator.table;
import static j2html.TagCreator.tbody;
import static j2html.TagCreator.td;
import static j2html.TagCreator.th;
import static j2html.TagCreator.text;
import static j2html.TagCreator.thead;
import static j2html.TagCreator.title;
import static j2html.TagCreator.tr;

import io.github.sofas.evaluate.Distribution;
import io.github.sofas.evaluate.Evaluation;
import io.github.sofas.render.Panel;
import j2html.TagCreator;
import j2html.tags.DomContent;
import j2html.tags.specialized.SectionTag;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.ToDoubleFunction;

/** The page of the experiments: HTML that needs no other file, no network and no script. */
final class ExperimentReport {
    private static final int SMALL_WIDTH = 300;
    private static final int SMALL_HEIGHT = 190;
    private static final int WIDE_WIDTH = 540;
    private static final int WIDE_HEIGHT = 300;
    private static final int MAP_SIDE = 400;
    /** In place of a figure that there are no events for. */
    private static final String NONE = "–";

    private final Experiments experiments;
    private final String version;

    ExperimentReport(Experiments experiments, String version) {
        this.experiments = experiments;
        this.version = version;
    }

    String page() {
        List<Chapter> chapters = List.of(
            new Chapter("claims", "What the paper says, and what comes out here", claims()),
            new Chapter("goals", "Goals", goals()),
            new Chapter("a", "(a) Four shapes at 58 px/s", shapes()),
            new Chapter("b", "(b) Three velocities", velocities()),
            new Chapter("c", "(c) Acceleration: a pendulum", pendulum()),
            new Chapter("d", "(d) Rotation: two bars", bars()),
            new Chapter("e", "(e) Convergence", convergence()),
            new Chapter("f", "(f) Metric maps", metricMaps()),
            new Chapter("g", "(g) Segmentation", segmentation()),
            new Chapter("h", "(h) Recordings of real cameras", real()),
            new Chapter("i", "(i) Random scenes, texture, growth", RandomChapter.of(experiments.randomScenes())),
            new Chapter("figures", "All figures", List.of(figures(Setting.ALL))),
            new Chapter("definitions", "What the figures mean", definitions()));
        return "<!DOCTYPE html>\n" + html(
            head(meta().withCharset("utf-8"),
                meta().withName("viewport").withContent("width=device-width, initial-scale=1"),
                title("SOFAS: the paper's experiments"),
                style(rawHtml(css()))),
            body(h1("The paper's experiments"),
                p("Flow and segmentation of events by SOFAS (Stoffregen and Kleeman, ACRA 2017), with the preset that "
                    + "is most accurate and with the method as published, beside Lucas-Kanade and local planes for "
                    + "events (Rueckauer and Delbruck 2016). The scenes are simulated for a DAVIS240C, so that object "
                    + "and velocity of every event are known exactly; the first 15 % of each film do not count."),
                p(format("sofas %s; all runs took %.0f s with %d at a time. Every number of this page is in the CSV "
                    + "files beside it.", version, experiments.seconds(), experiments.jobs())).withClass("soft"),
                nav(ol(each(chapters, chapter -> li(a(chapter.title).withHref("#" + chapter.id))))),
                each(chapters, ExperimentReport::section))).withLang("en").render() + "\n";
    }

    /** A chapter of the page. */
    private record Chapter(String id, String title, List<DomContent> content) {
    }

    private static SectionTag section(Chapter chapter) {
        return TagCreator.section(h2(chapter.title).withId(chapter.id), each(chapter.content, content -> content));
    }

    private static String css() {
        try (InputStream css = ExperimentReport.class.getResourceAsStream("page.css")) {
            return new String(css.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /**
     * What the paper's text states, and the figure that decides it here.
     *
     * @param statement the paper's
     * @param figure in words, with its unit
     * @param settings that it is about
     * @param value the figure
     */
    private record Claim(String statement, String figure, List<Setting> settings, ToDoubleFunction<Evaluation> value) {
    }

    private List<DomContent> claims() {
        List<Claim> claims = List.of(
            new Claim("Lucas-Kanade under-estimates the magnitude by about 35 %", "magnitude error, mean, %",
                Setting.SHAPES, e -> e.flow().magnitudeErrorPercent().mean()),
            new Claim("SOFAS has the lower standard deviation of errors", "magnitude error, sd, %", Setting.SHAPES,
                e -> e.flow().magnitudeErrorPercent().sd()),
            new Claim("SOFAS is far superior in direction, but for the small circle, where both are about even",
                "angular error, mean, °", Setting.SHAPES, e -> e.flow().angularErrorDeg().mean()),
            new Claim("SOFAS is slightly better at higher velocities", "relative AEE at 5.8, 58 and 289 px/s, %",
                Setting.VELOCITIES, e -> e.flow().relativeEndpointErrorPercent().mean()),
            new Claim("A pendulum gives a relatively noisy, but reasonable estimate", "AEE, of the peak speed, %",
                List.of(Setting.PENDULUM), e -> e.flow().endpointErrorPercentOfPeak()),
            new Claim("SOFAS performs poorly on rotating bars, worst on the long one",
                "relative AEE, short and long, %", Setting.BARS, e -> e.flow().relativeEndpointErrorPercent().mean()));
        List<ComparedMethod> methods = List.of(ComparedMethod.values());
        return List.of(
            p("The paper shows its results as pictures; these are the statements of its text. Figures of the four "
                + "shapes are in the order rectangles, hexagon, large circle, small circle."),
            div(table(
                thead(tr(th("the paper").withClass("name"), th("figure here").withClass("name"),
                    each(methods, method -> th(method.title())))),
                tbody(each(claims, claim -> tr(td(claim.statement).withClass("wrap"),
                    td(claim.figure).withClass("wrap"), each(methods, method -> td(values(claim, method))))))))
                .withClass("scroll"),
            p(text("The paper's own speed was 6,000 events a second (81,700 events in 13.6 s); "),
                code("./sofas bench"),
                text(" measures this one's.")));
    }

    private String values(Claim claim, ComparedMethod method) {
        return String.join(", ", claim.settings.stream().map(setting -> {
            Evaluation evaluation = experiments.trial(setting, method).evaluation();
            return evaluation.flow().eventsWithFlow() == 0 ? NONE
                : format("%.1f", claim.value.applyAsDouble(evaluation));
        }).toList());
    }

    private List<DomContent> goals() {
        Map<String, List<Goal.Check>> all = experiments.checksByScene();
        Map<String, List<Goal.Check>> missed = new LinkedHashMap<>();
        int count = 0;
        int met = 0;
        for (Map.Entry<String, List<Goal.Check>> scene : all.entrySet()) {
            List<Goal.Check> misses = scene.getValue().stream().filter(check -> !check.met()).toList();
            count += scene.getValue().size();
            met += scene.getValue().size() - misses.size();
            if (!misses.isEmpty()) {
                missed.put(scene.getKey(), misses);
            }
        }
        return List.of(
            p(format("The default preset reaches %d of the %d goals that were set for it, and misses these:", met,
                count)),
            checks(missed),
            details(summary("All goals"), checks(all)));
    }

    private static DomContent checks(Map<String, List<Goal.Check>> byScene) {
        List<DomContent> rows = new ArrayList<>();
        byScene.forEach((scene, checks) -> rows.addAll(goalRows(scene, checks)));
        return div(table(thead(tr(th("scene").withClass("name"), th("figure").withClass("name"), th("goal"),
            th("reached"), th())), tbody(each(rows, row -> row))).withClass("goals")).withClass("scroll");
    }

    private static List<DomContent> goalRows(String scene, List<Goal.Check> checks) {
        List<DomContent> rows = new ArrayList<>();
        for (int i = 0; i < checks.size(); i++) {
            Goal.Check check = checks.get(i);
            rows.add(tr(td(i == 0 ? scene : "").withClass("name"), td(check.figure()).withClass("name"),
                td(check.goal()), td(check.reached()),
                td(check.met() ? "✓ met" : "✗ missed").withClass(check.met() ? "good" : "bad"))
                .withClass(i == 0 ? "first" : ""));
        }
        return rows;
    }

    private List<DomContent> shapes() {
        List<DomContent> content = new ArrayList<>();
        content.add(paper("Four shapes moved by a robot arm at 58 px/s. Lucas-Kanade, with a window of 7 x 7 pixels, "
            + "sees only what is across an edge (the aperture problem), and under-estimates the magnitude by about "
            + "35 %; SOFAS looks at the whole structure."));
        content.add(figures(Setting.SHAPES));
        for (Setting setting : Setting.SHAPES) {
            content.add(h3(setting.title()));
            content.add(div(histograms(setting, List.of(ComparedMethod.values()), true),
                histograms(setting, List.of(ComparedMethod.values()), false)).withClass("grid"));
        }
        content.add(p("Bins of 2 % and 4°; each histogram has its own vertical axis.").withClass("soft"));
        return content;
    }

    private DomContent histograms(Setting setting, List<ComparedMethod> methods, boolean magnitude) {
        return each(methods, method -> {
            Trial trial = experiments.trial(setting, method);
            Distribution errors = magnitude ? trial.evaluation().flow().magnitudeErrorPercent()
                : trial.evaluation().flow().directionErrorDeg();
            String spread = format(magnitude ? "%.1f ± %.1f %%" : "%.1f ± %.1f°", errors.mean(), errors.sd());
            return figure(picture(Charts.of(magnitude ? trial.magnitudeError() : trial.directionError(),
                method.title() + ": " + spread, magnitude ? "magnitude error, %" : "direction error, °",
                Plot.Ink.of(method), SMALL_WIDTH, SMALL_HEIGHT)));
        });
    }

    private List<DomContent> velocities() {
        List<DomContent> content = new ArrayList<>();
        content.add(paper("The hexagon at 5.8, 58 and 289 px/s: slightly better at higher velocities."));
        content.add(figures(Setting.VELOCITIES));
        for (Setting setting : Setting.VELOCITIES) {
            content.add(h3(setting.title()));
            List<ComparedMethod> both = List.of(ComparedMethod.SOFAS_DEFAULT, ComparedMethod.SOFAS_PAPER);
            content.add(div(histograms(setting, both, true), histograms(setting, both, false)).withClass("grid"));
        }
        return content;
    }

    private List<DomContent> pendulum() {
        return List.of(
            paper("A pendulum of 0.72 m let go at 23°: a relatively noisy, but reasonable estimate where nothing is "
                + "constant."),
            figures(List.of(Setting.PENDULUM)), plots(Plots.pendulum(experiments)),
            p("Medians over the object's events in bins of 20 ms. The speed passes zero where the pendulum turns "
                + "round; relative errors there are large, so the endpoint error is best taken relative to the peak "
                + "speed.").withClass("soft"));
    }

    private List<DomContent> bars() {
        return List.of(
            paper("Two bars turning once a second. Projections do not model rotation, so SOFAS performs poorly; the "
                + "long bar, which fills the frame, suffers from the aperture problem."),
            figures(Setting.BARS),
            p("How to read the pictures here and below:"),
            figure(picture(experiments.trial(Setting.THREE_WANDERING, ComparedMethod.SOFAS_DEFAULT).strip()
                .withLegends())).withClass("key"),
            join(each(Setting.BARS, this::strips)));
    }

    /** What the default preset sees at four moments, and what the others see at the third. */
    private DomContent strips(Setting setting) {
        List<DomContent> ours = new ArrayList<>();
        Strip strip = experiments.trial(setting, ComparedMethod.SOFAS_DEFAULT).strip();
        for (Panel panel : Strip.PANELS) {
            for (Strip.Moment moment : strip.moments()) {
                ours.add(captioned(moment, panel, ""));
            }
        }
        List<DomContent> others = new ArrayList<>();
        Strip.Moment paper = experiments.trial(setting, ComparedMethod.SOFAS_PAPER).strip().moments().get(2);
        others.add(captioned(paper, Panel.FLOW, "SOFAS, paper: "));
        others.add(captioned(paper, Panel.SEGMENTS, "SOFAS, paper: "));
        for (ComparedMethod method : List.of(ComparedMethod.LUCAS_KANADE, ComparedMethod.LOCAL_PLANES)) {
            others.add(captioned(experiments.trial(setting, method).strip().moments().get(2), Panel.FLOW,
                method.title() + ": "));
        }
        return join(h3(setting.title()),
            p(format("Full colour, and an arrow of a fifth of a picture's width: %.0f px/s. SOFAS, default:",
                strip.fullPxPerS())).withClass("soft"),
            div(each(ours, figure -> figure)).withClass("grid"),
            div(each(others, figure -> figure)).withClass("grid"));
    }

    static DomContent captioned(Strip.Moment moment, Panel panel, String before) {
        return figure(picture(moment.pictures().get(panel)),
            figcaption(format("%s%s, %.2f s", before, panel, moment.timeUs() * 1e-6)));
    }

    private List<DomContent> convergence() {
        return List.of(
            p("How the error falls, and the share of events with flow rises, after the object appears."),
            h3("Endpoint error relative to the true speed"),
            plots(Setting.SHAPES.stream().map(s -> Plots.convergenceOfError(experiments, s)).toList()),
            h3("Share of the object's events with flow"),
            plots(Setting.SHAPES.stream().map(s -> Plots.convergenceOfShare(experiments, s)).toList()));
    }

    private List<DomContent> metricMaps() {
        MetricMap one = experiments.oneObject();
        MetricMap two = experiments.twoObjects();
        return List.of(
            paper("The metric of a projection, the sum of its squared cells, is greatest at the true velocity; with "
                + "two structures there are two maxima."),
            figure(picture(experiments.methodPicture())),
            div(figure(picture(Charts.of(one, "Metrics of one object", MAP_SIDE)),
                    figcaption(format("%d x %d projections of %,d events of the hexagon, which moves at (58, 0) px/s. "
                        + "Greatest at %s.", one.n(), one.n(), one.events(), maxima(one, one.n() / 10, 1)))),
                figure(picture(Charts.of(two, "Metrics of two objects", MAP_SIDE)),
                    figcaption(format("%d x %d projections of %,d events of two movers, at (58, 0) and (-72.5, 0) "
                        + "px/s. The two greatest maxima are at %s.", two.n(), two.n(), two.events(),
                        maxima(two, 2, 2)))))
                .withClass("grid wide"),
            p("Darker is higher, by the square root above the least. Projections are evenly spaced in angle, as in "
                + "the paper, with 100 px/s at 45°. Events fall on the nearest cell and vote with their sign; they "
                + "are those of 0.1 s.").withClass("soft"));
    }

    private static String maxima(MetricMap map, int steps, int most) {
        return String.join(" and ", map.maxima(steps, most).stream()
            .map(m -> format("(%.1f, %.1f)", m.vxPxPerS(), m.vyPxPerS())).toList()) + " px/s";
    }

    private List<DomContent> segmentation() {
        return List.of(
            paper("Cockroaches that wander, a pan past bars at four depths, an object that is hidden and found again: "
                + "segmented clearly, sometimes in parts that are merged later."),
            figures(Setting.SEVERAL),
            p("Lucas-Kanade and local planes find no segments: all their events are taken as one.").withClass("soft"),
            join(each(Setting.SEVERAL.stream().filter(Setting.PICTURED::contains).toList(), this::strips)));
    }

    private List<DomContent> real() {
        List<DomContent> content = new ArrayList<>();
        if (!experiments.missing().isEmpty()) {
            content.add(p(experiments.real().isEmpty() && experiments.failures().isEmpty()
                ? "No recordings of real cameras were given (--recordings DIR), so this part is left out."
                : "Not found, and left out: " + String.join(", ", experiments.missing()) + "."));
        }
        experiments.failures().forEach(failure -> content.add(p(failure).withClass("bad")));
        for (RealExperiment real : experiments.real()) {
            content.add(h3(real.file()));
            content.add(p(real.about()));
            content.add(plainTable(real.header(), real.rows()));
            content.add(plots(real.plots()));
        }
        return content;
    }

    private static DomContent plainTable(List<String> header, List<List<String>> rows) {
        return div(table(thead(tr(each(header, cell -> th(cell)))),
            tbody(each(rows, row -> tr(td(row.get(0)).withClass("name"),
                each(row.subList(1, row.size()), cell -> td(cell))))))).withClass("scroll");
    }

    /** A row a setting and method. */
    private DomContent figures(List<Setting> settings) {
        List<DomContent> rows = new ArrayList<>();
        for (Setting setting : settings) {
            for (ComparedMethod method : ComparedMethod.values()) {
                Evaluation e = experiments.trial(setting, method).evaluation();
                boolean first = method == ComparedMethod.SOFAS_DEFAULT;
                rows.add(tr(td(first ? setting.title() : "").withClass("name"), td(method.title()).withClass("name"),
                    td(meanAndSd(e.flow().magnitudeErrorPercent())), td(meanAndSd(e.flow().directionErrorDeg())),
                    td(format("%.1f", 100 * e.flow().shareWithFlow())),
                    td(mean(e.flow().endpointErrorPxPerS())), td(mean(e.flow().relativeEndpointErrorPercent())),
                    td(format("%.1f", 100 * e.noiseShareWithFlow())),
                    td(method.segmenting() ? format("%.3f", e.segmentation().meanIou()) : NONE),
                    td(method.segmenting() ? format("%.2f", e.segmentation().partsPerObject()) : NONE),
                    td(e.segmentation().labelled() == 0 ? NONE : format("%.0f ms, %.1f px",
                        e.segmentation().firstLabelledUs() / 1e3, e.segmentation().firstLabelledPx())))
                    .withClass(first ? "first ours" : ""));
            }
        }
        return div(table(
            thead(tr(th("scene").withClass("name"), th("method").withClass("name"),
                th(rawHtml("magnitude<br>error, %")),
                th(rawHtml("direction<br>error, °")), th(rawHtml("with<br>flow, %")), th(rawHtml("AEE,<br>px/s")),
                th(rawHtml("relative<br>AEE, %")),
                th(rawHtml("noise with<br>flow, %")), th(rawHtml("best<br>IoU")),
                th(rawHtml("parts an<br>object")), th(rawHtml("first<br>labelled")))),
            tbody(each(rows, row -> row)))).withClass("scroll");
    }

    private static String meanAndSd(Distribution errors) {
        return errors.count() == 0 ? NONE : format("%.1f ± %.1f", errors.mean(), errors.sd());
    }

    private static String mean(Distribution errors) {
        return errors.count() == 0 ? NONE : format("%.1f", errors.mean());
    }

    private static List<DomContent> definitions() {
        return List.of(
            p("With the true velocity v of an event and the estimate u, over object events that have flow:"),
            dl(term("magnitude error", "100 (|u| - |v|) / |v|, mean ± standard deviation."),
                term("direction error", "the angle from v to u, mean ± standard deviation; the angular error is it "
                    + "without its sign."),
                term("with flow", "share of the object events that get a velocity."),
                term("AEE", "mean endpoint error |u - v|; relative: 100 |u - v| / |v|."),
                term("noise with flow", "share of the noise events that get a velocity."),
                term("best IoU", "in windows of 50 ms, of each object's events and those of the segment that suits it "
                    + "best, the intersection over the union; noise counts against it."),
                term("parts an object", "segments that hold at least 5 % of an object's labelled events, in the same "
                    + "windows."),
                term("first labelled", "time and travel from an object's first event until its events get flow, the "
                    + "longest of all objects.")),
            p(text("Relative figures leave out events slower than 1 px/s. "), code("./sofas evaluate"),
                text(" gives these figures and more for any recording with truth; docs/accuracy.md and "
                    + "the package io.github.sofas.evaluate hold all definitions and how they follow jAER's.")));
    }

    private static DomContent term(String name, String meaning) {
        return join(dt(name), dd(meaning));
    }

    private static DomContent paper(String text) {
        return p(span("The paper: "), text(text)).withClass("paper");
    }

    private static DomContent plots(List<Plot> plots) {
        return div(each(plots, plot -> figure(picture(Charts.of(plot, WIDE_WIDTH, WIDE_HEIGHT)))))
            .withClass("grid wide");
    }

    private static DomContent picture(Picture picture) {
        return TagCreator.picture(
            source().attr("media", "(prefers-color-scheme: dark)").attr("srcset", data(picture.dark())),
            img().withSrc(data(picture.light())).withAlt(picture.alt()).attr("width", picture.width())
                .attr("height", picture.height()));
    }

    private static String data(byte[] png) {
        return "data:image/png;base64," + Base64.getEncoder().encodeToString(png);
    }

    /** Formats; what rounds to zero has no sign, and % stays with its number. */
    private static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values).replaceAll("-(0(\\.0+)?)(?![.\\d])", "$1")
            .replace(" %", "\u00A0%");
    }
}
