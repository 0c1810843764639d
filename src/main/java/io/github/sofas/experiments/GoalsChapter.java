package io.github.sofas.experiments;

import static io.github.sofas.experiments.PageParts.format;
import static j2html.TagCreator.details;
import static j2html.TagCreator.div;
import static j2html.TagCreator.each;
import static j2html.TagCreator.p;
import static j2html.TagCreator.summary;
import static j2html.TagCreator.table;
import static j2html.TagCreator.tbody;
import static j2html.TagCreator.td;
import static j2html.TagCreator.th;
import static j2html.TagCreator.thead;
import static j2html.TagCreator.tr;

import j2html.tags.DomContent;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** The chapter about the goals that were set for the default preset: first those that it misses, then all. */
final class GoalsChapter {
    private GoalsChapter() {
    }

    static List<DomContent> of(Experiments experiments) {
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
}
