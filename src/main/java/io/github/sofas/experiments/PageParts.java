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

/** What the chapters of the page are made of. */
final class PageParts {
    /** In place of a figure that there are no events for. */
    static final String NONE = "–";

    private static final int WIDE_WIDTH = 540;
    private static final int WIDE_HEIGHT = 300;

    private PageParts() {
    }

    /** What the paper says of an experiment. */
    static DomContent paper(String text) {
        return p(span("The paper: "), text(text)).withClass("paper");
    }

    /** Plots side by side. */
    static DomContent plots(List<Plot> plots) {
        return div(each(plots, plot -> figure(picture(Charts.of(plot, WIDE_WIDTH, WIDE_HEIGHT)))))
            .withClass("grid wide");
    }

    /** A picture that follows whether the page is dark or light. */
    static DomContent picture(Picture picture) {
        return TagCreator.picture(
            source().attr("media", "(prefers-color-scheme: dark)").attr("srcset", data(picture.dark())),
            img().withSrc(data(picture.light())).withAlt(picture.alt()).attr("width", picture.width())
                .attr("height", picture.height()));
    }

    private static String data(byte[] png) {
        return "data:image/png;base64," + Base64.getEncoder().encodeToString(png);
    }

    /** One panel of a moment with what it shows below. */
    static DomContent captioned(Strip.Moment moment, Panel panel, String before) {
        return figure(picture(moment.pictures().get(panel)),
            figcaption(format("%s%s, %.2f s", before, panel, moment.timeUs() * 1e-6)));
    }

    /** A table of texts, the first column of names. */
    static DomContent plainTable(List<String> header, List<List<String>> rows) {
        return div(table(thead(tr(each(header, cell -> th(cell)))),
            tbody(each(rows, row -> tr(td(row.get(0)).withClass("name"),
                each(row.subList(1, row.size()), cell -> td(cell))))))).withClass("scroll");
    }

    /** Formats; what rounds to zero has no sign, and % stays with its number. */
    static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values).replaceAll("-(0(\\.0+)?)(?![.\\d])", "$1")
            .replace(" %", "\u00A0%");
    }
}
