package io.github.sofas.experiments;

import static j2html.TagCreator.div;
import static j2html.TagCreator.each;
import static j2html.TagCreator.figcaption;
import static j2html.TagCreator.figure;
import static j2html.TagCreator.img;
import static j2html.TagCreator.p;
import static j2html.TagCreator.source;
import static j2html.TagCreator.span;
import static j2html.TagCreator.table;
import static j2html.TagCreator.tbody;
import static j2html.TagCreator.td;
import static j2html.TagCreator.text;
import static j2html.TagCreator.th;
import static j2html.TagCreator.thead;
import static j2html.TagCreator.tr;

import io.github.sofas.render.Panel;
import j2html.TagCreator;
import j2html.tags.DomContent;
import java.util.Base64;
import java.util.List;
import java.util.Locale;

/** The building blocks of the chapters of the page: tables, plots, pictures, captions and the format of numbers. */
final class PageParts {
    /** Stands for a figure without events. */
    static final String NONE = "–";

    private static final int WIDE_WIDTH = 540;
    private static final int WIDE_HEIGHT = 300;

    private PageParts() {
    }

    /** The paper's statement about an experiment. */
    static DomContent paper(String text) {
        return p(span("The paper: "), text(text)).withClass("paper");
    }

    /** Plots side by side. */
    static DomContent plots(List<Plot> plots) {
        return div(each(plots, plot -> figure(picture(Charts.of(plot, WIDE_WIDTH, WIDE_HEIGHT)))))
            .withClass("grid wide");
    }

    /** A picture that adapts to a dark or light page. */
    static DomContent picture(Picture picture) {
        return TagCreator.picture(
            source().attr("media", "(prefers-color-scheme: dark)").attr("srcset", data(picture.dark())),
            img().withSrc(data(picture.light())).withAlt(picture.alt()).attr("width", picture.width())
                .attr("height", picture.height()));
    }

    private static String data(byte[] png) {
        return "data:image/png;base64," + Base64.getEncoder().encodeToString(png);
    }

    /** One panel of a moment, with a caption below that names what it shows. */
    static DomContent captioned(Strip.Moment moment, Panel panel, String before) {
        return figure(picture(moment.pictures().get(panel)),
            figcaption(format("%s%s, %.2f s", before, panel, moment.timeUs() * 1e-6)));
    }

    /** A table of texts, with names in the first column. */
    static DomContent plainTable(List<String> header, List<List<String>> rows) {
        return div(table(thead(tr(each(header, cell -> th(cell)))),
            tbody(each(rows, row -> tr(td(row.get(0)).withClass("name"),
                each(row.subList(1, row.size()), cell -> td(cell))))))).withClass("scroll");
    }

    /** Formats values. A number that rounds to zero has no sign, and % stays on the line of its number. */
    static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values).replaceAll("-(0(\\.0+)?)(?![.\\d])", "$1")
            .replace(" %", "\u00A0%");
    }
}
