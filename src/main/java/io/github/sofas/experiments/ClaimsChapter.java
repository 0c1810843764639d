package io.github.sofas.experiments;

import static io.github.sofas.experiments.PageParts.NONE;
import static io.github.sofas.experiments.PageParts.format;
import static j2html.TagCreator.code;
import static j2html.TagCreator.div;
import static j2html.TagCreator.each;
import static j2html.TagCreator.p;
import static j2html.TagCreator.table;
import static j2html.TagCreator.tbody;
import static j2html.TagCreator.td;
import static j2html.TagCreator.text;
import static j2html.TagCreator.th;
import static j2html.TagCreator.thead;
import static j2html.TagCreator.tr;

import io.github.sofas.evaluate.Evaluation;
import j2html.tags.DomContent;
import java.util.List;
import java.util.function.ToDoubleFunction;

/**
 * The chapter about the statements in the text of the paper: a table of each statement, and the figures here that
 * decide it for each method.
 */
final class ClaimsChapter {
    /**
     * A statement of the paper's text, and the figure that decides it here.
     *
     * @param statement the paper's statement
     * @param figure the figure in words, with its unit
     * @param settings the settings that the statement is about
     * @param value computes the figure
     */
    private record Claim(String statement, String figure, List<Setting> settings, ToDoubleFunction<Evaluation> value) {
    }

    private static final List<Claim> CLAIMS = List.of(
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

    private ClaimsChapter() {
    }

    static List<DomContent> of(Experiments experiments) {
        List<ComparedMethod> methods = List.of(ComparedMethod.values());
        return List.of(
            p("The paper shows its results as pictures; these are the statements of its text. Figures of the four "
                + "shapes are in the order rectangles, hexagon, large circle, small circle."),
            div(table(
                thead(tr(th("the paper").withClass("name"), th("figure here").withClass("name"),
                    each(methods, method -> th(method.title())))),
                tbody(each(CLAIMS, claim -> tr(td(claim.statement).withClass("wrap"),
                    td(claim.figure).withClass("wrap"),
                    each(methods, method -> td(values(experiments, claim, method))))))))
                .withClass("scroll"),
            p(text("The paper's own speed was 6,000 events per second (81,700 events in 13.6 s); "),
                code("./sofas bench"),
                text(" measures this one's.")));
    }

    private static String values(Experiments experiments, Claim claim, ComparedMethod method) {
        return String.join(", ", claim.settings.stream().map(setting -> {
            Evaluation evaluation = experiments.trial(setting, method).evaluation();
            return evaluation.flow().eventsWithFlow() == 0 ? NONE
                : format("%.1f", claim.value.applyAsDouble(evaluation));
        }).toList());
    }
}
