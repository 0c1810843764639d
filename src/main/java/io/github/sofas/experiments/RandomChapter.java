package io.github.sofas.experiments;

import static j2html.TagCreator.div;
import static j2html.TagCreator.each;
import static j2html.TagCreator.h3;
import static j2html.TagCreator.join;
import static j2html.TagCreator.p;
import static j2html.TagCreator.table;
import static j2html.TagCreator.tbody;
import static j2html.TagCreator.td;
import static j2html.TagCreator.th;
import static j2html.TagCreator.thead;
import static j2html.TagCreator.tr;

import io.github.sofas.experiments.SceneFigures.Column;
import io.github.sofas.render.Panel;
import j2html.tags.DomContent;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;

/** The chapter about random and textured scenes: two tables of figures, and pictures of the worst random scenes. */
final class RandomChapter {
    private static final List<Panel> PANELS = List.of(Panel.FLOW, Panel.SEGMENTS);

    private RandomChapter() {
    }

    static List<DomContent> of(RandomScenes scenes) {
        List<DomContent> summary = List.of(row("mean", column -> column.text(column.mean(scenes.random()))),
            row("worst tenth", column -> column.text(column.worstTenth(scenes.random()))),
            row("worst", column -> column.text(column.worst(scenes.random()))));
        List<DomContent> textured = new ArrayList<>();
        scenes.textured().forEach(scene -> textured.add(row(scene.name(),
            column -> scene.has(column) ? column.text(column.of(scene)) : "–")));
        return List.of(
            p("What is right on chosen scenes may be wrong on others. " + scenes.random().size() + " random scenes of "
                + "2 to 8 opaque shapes: size, outline, texture, speed (20 to 200 px/s), direction and depth are drawn "
                + "by chance; some turn, stop or turn back, some are seen before a moving background. SOFAS, default. "
                + "A tenth of the scenes is no better than the worst tenth. IoU and parts are of the segments; fast is "
                + "the share of the events with flow that are faster than twice the fastest true speed."),
            figures("random scenes", summary),
            p("Cameras that pan, roll and move forward before a textured wall, a shape that comes near, textured "
                + "movers before a moving wall, and a lamp that flickers over a still scene. Walls show edges, or else "
                + "soft noise (smooth) or that of all sizes (fractal):"),
            figures("scene", textured),
            join(each(scenes.worst(), RandomChapter::pictures)));
    }

    private static DomContent row(String name, Function<Column, String> text) {
        return tr(td(name).withClass("name"), each(Column.ofResults(), column -> td(text.apply(column))));
    }

    private static DomContent figures(String title, List<DomContent> rows) {
        return div(table(
            thead(tr(th(title).withClass("name"), each(Column.ofResults(), column -> th(column.title())))),
            tbody(each(rows, row -> row)))).withClass("scroll");
    }

    private static DomContent pictures(RandomScenes.Pictured scene) {
        List<DomContent> pictures = new ArrayList<>();
        for (Panel panel : PANELS) {
            for (Strip.Moment moment : scene.strip().moments()) {
                pictures.add(PageParts.captioned(moment, panel, ""));
            }
        }
        return join(h3("Among the worst: " + scene.figures().name()),
            p(String.format(Locale.ROOT, "%d objects, IoU %.3f, %.2f parts an object, relative endpoint error %.1f %%. "
                + "Full colour, and an arrow of a fifth of a picture's width: %.0f px/s.", scene.figures().objects(),
                Column.IOU.of(scene.figures()), Column.PARTS.of(scene.figures()), Column.ERROR.of(scene.figures()),
                scene.strip().fullPxPerS())).withClass("soft"),
            div(each(pictures, figure -> figure)).withClass("grid"));
    }
}
