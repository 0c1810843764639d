package io.github.sofas.experiments;

import static io.github.sofas.experiments.PageParts.captioned;
import static io.github.sofas.experiments.PageParts.format;
import static io.github.sofas.experiments.PageParts.paper;
import static io.github.sofas.experiments.PageParts.picture;
import static io.github.sofas.experiments.PageParts.plots;
import static io.github.sofas.experiments.PageParts.plainTable;
import static j2html.TagCreator.a;
import static j2html.TagCreator.body;
import static j2html.TagCreator.code;
import static j2html.TagCreator.dd;
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
import static j2html.TagCreator.join;
import static j2html.TagCreator.li;
import static j2html.TagCreator.meta;
import static j2html.TagCreator.nav;
import static j2html.TagCreator.ol;
import static j2html.TagCreator.p;
import static j2html.TagCreator.rawHtml;
import static j2html.TagCreator.style;
import static j2html.TagCreator.text;
import static j2html.TagCreator.title;

import io.github.sofas.evaluate.Distribution;
import io.github.sofas.render.Panel;
import j2html.TagCreator;
import j2html.tags.DomContent;
import j2html.tags.specialized.SectionTag;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/**
 * The page of the experiments, chapter by chapter: HTML that needs no other file, no network and no script. The
 * chapters on the paper's experiments set its statements beside the tables, plots and pictures of the results.
 */
final class ExperimentReport {
    private static final int SMALL_WIDTH = 300;
    private static final int SMALL_HEIGHT = 190;
    private static final int MAP_SIDE = 400;

    private final Experiments experiments;
    private final String version;

    ExperimentReport(Experiments experiments, String version) {
        this.experiments = experiments;
        this.version = version;
    }

    String page() {
        List<Chapter> chapters = List.of(
            new Chapter("claims", "What the paper says, and what comes out here", ClaimsChapter.of(experiments)),
            new Chapter("goals", "Goals", GoalsChapter.of(experiments)),
            new Chapter("a", "(a) Four shapes at 58 px/s", shapes()),
            new Chapter("b", "(b) Three velocities", velocities()),
            new Chapter("c", "(c) Acceleration: a pendulum", pendulum()),
            new Chapter("d", "(d) Rotation: two bars", bars()),
            new Chapter("e", "(e) Convergence", convergence()),
            new Chapter("f", "(f) Metric maps", metricMaps()),
            new Chapter("g", "(g) Segmentation", segmentation()),
            new Chapter("h", "(h) Recordings of real cameras", real()),
            new Chapter("i", "(i) Random scenes, texture, growth", RandomChapter.of(experiments.randomScenes())),
            new Chapter("figures", "All figures", List.of(FigureTable.of(experiments, Setting.ALL))),
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

    private List<DomContent> shapes() {
        List<DomContent> content = new ArrayList<>();
        content.add(paper("Four shapes moved by a robot arm at 58 px/s. Lucas-Kanade, with a window of 7 x 7 pixels, "
            + "sees only what is across an edge (the aperture problem), and under-estimates the magnitude by about "
            + "35 %; SOFAS looks at the whole structure."));
        content.add(FigureTable.of(experiments, Setting.SHAPES));
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
        content.add(FigureTable.of(experiments, Setting.VELOCITIES));
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
            FigureTable.of(experiments, List.of(Setting.PENDULUM)), plots(Plots.pendulum(experiments)),
            p("Medians over the object's events in bins of 20 ms. The speed passes zero where the pendulum turns "
                + "round; relative errors there are large, so the endpoint error is best taken relative to the peak "
                + "speed.").withClass("soft"));
    }

    private List<DomContent> bars() {
        return List.of(
            paper("Two bars turning once a second. Projections do not model rotation, so SOFAS performs poorly; the "
                + "long bar, which fills the frame, suffers from the aperture problem."),
            FigureTable.of(experiments, Setting.BARS),
            p("How to read the pictures here and below:"),
            figure(picture(experiments.trial(Setting.THREE_WANDERING, ComparedMethod.SOFAS_DEFAULT).strip()
                .withLegends())).withClass("key"),
            join(each(Setting.BARS, this::strips)));
    }

    /** Pictures of the default preset at four moments, and of the other methods at the third. */
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
            FigureTable.of(experiments, Setting.SEVERAL),
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
}
