package io.github.sofas.experiments;

import static io.github.sofas.experiments.PageParts.NONE;
import static io.github.sofas.experiments.PageParts.format;
import static j2html.TagCreator.div;
import static j2html.TagCreator.each;
import static j2html.TagCreator.rawHtml;
import static j2html.TagCreator.table;
import static j2html.TagCreator.tbody;
import static j2html.TagCreator.td;
import static j2html.TagCreator.th;
import static j2html.TagCreator.thead;
import static j2html.TagCreator.tr;

import io.github.sofas.evaluate.Distribution;
import io.github.sofas.evaluate.Evaluation;
import j2html.tags.DomContent;
import java.util.ArrayList;
import java.util.List;

/** The table of the figures of every method in simulated scenes, for the page. */
final class FigureTable {
    private FigureTable() {
    }

    /** Makes a table with one row per setting and method. */
    static DomContent of(Experiments experiments, List<Setting> settings) {
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
}
