package io.github.sofas.report;

import static j2html.TagCreator.tag;

import j2html.tags.ContainerTag;
import java.util.Locale;

/**
 * Elements of the page's drawings, which are SVG inside it, not pictures of a plot library: they take the colours of a
 * light or dark page, stay sharp on any screen, and say their values when pointed at.
 */
final class Svg {
    /** Width of a plot over time, and what its labels take at the left and below, in units of the drawing. */
    static final int WIDTH = 640;
    static final int LEFT = 56;
    static final int BOTTOM = 30;

    private Svg() {
    }

    /** A drawing that is described to who does not see it. */
    static ContainerTag<?> drawing(String style, String viewBox, String label) {
        return tag("svg").attr("class", style).attr("viewBox", viewBox).attr("role", "img").attr("aria-label", label);
    }

    /** A text at a place. */
    static ContainerTag<?> text(double x, double y, String style, String text) {
        return tag("text").attr("x", number(x)).attr("y", number(y))
            .condAttr(!style.isEmpty(), "class", style).withText(text);
    }

    /** A path, with what is said when it is pointed at. */
    static ContainerTag<?> path(String style, String d, String said) {
        return tag("path").condAttr(!style.isEmpty(), "class", style).attr("d", d).with(tag("title").withText(said));
    }

    /** Place of a time in a plot of a duration. */
    static double x(double s, double durationS) {
        return LEFT + (WIDTH - LEFT) * Math.max(0, Math.min(1, s / durationS));
    }

    /** Adds the labels of an axis of time below a height. */
    static void addTimeAxis(ContainerTag<?> drawing, double durationS, int y) {
        for (int i = 0; i <= 4; i++) {
            double s = durationS * i / 4;
            drawing.with(text(x(s, durationS), y + 18, i == 0 ? "" : i == 4 ? "end" : "middle",
                String.format(Locale.ROOT, "%.2f%s", s, i == 4 ? " s" : "")));
        }
    }

    /** A coordinate to a tenth. */
    static String number(double value) {
        return String.format(Locale.ROOT, "%.1f", value);
    }
}
