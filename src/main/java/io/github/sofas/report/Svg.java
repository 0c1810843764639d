package io.github.sofas.report;

import static j2html.TagCreator.tag;

import j2html.tags.ContainerTag;
import java.util.Locale;

/**
 * Elements of the page's drawings. The drawings are SVG inside the page and not pictures of a plot library: they take
 * the colours of a light or dark page, stay sharp on any screen, and show their values on hover.
 */
final class Svg {
    /** Width of a plot over time, and the space for its labels at the left and below, in units of the drawing. */
    static final int WIDTH = 640;
    static final int LEFT = 56;
    static final int BOTTOM = 30;

    private Svg() {
    }

    /** A drawing with a description for readers who do not see it. */
    static ContainerTag<?> drawing(String style, String viewBox, String label) {
        return tag("svg").attr("class", style).attr("viewBox", viewBox).attr("role", "img").attr("aria-label", label);
    }

    /** A text at a place. */
    static ContainerTag<?> text(double x, double y, String style, String text) {
        return tag("text").attr("x", number(x)).attr("y", number(y))
            .condAttr(!style.isEmpty(), "class", style).withText(text);
    }

    /** A path with a text that is shown on hover. */
    static ContainerTag<?> path(String style, String d, String said) {
        return tag("path").condAttr(!style.isEmpty(), "class", style).attr("d", d).with(tag("title").withText(said));
    }

    /** Horizontal position of a time in a plot of a duration. */
    static double x(double s, double durationS) {
        return LEFT + (WIDTH - LEFT) * Math.max(0, Math.min(1, s / durationS));
    }

    /** Adds the labels of a time axis below a height, at round times. */
    static void addTimeAxis(ContainerTag<?> drawing, double durationS, int y) {
        double step = roundStep(durationS);
        // the last label has the unit, because it has room for the unit
        int last = (int) Math.floor(durationS / step + 1e-9);
        for (int i = 0; i <= last; i++) {
            double s = i * step;
            boolean isAtEnd = x(s, durationS) > WIDTH - LEFT / 2.0;
            drawing.with(text(x(s, durationS), y + 18, i == 0 ? "" : isAtEnd ? "end" : "middle",
                label(s, step) + (i == last ? " s" : "")));
        }
    }

    /** The step of an axis: 1, 2 or 5 times a power of ten, so that the range holds three to seven whole steps. */
    static double roundStep(double range) {
        double power = Math.pow(10, Math.floor(Math.log10(range / 3)));
        for (int factor : new int[] {5, 2}) {
            if (range / (factor * power) >= 3) {
                return factor * power;
            }
        }
        return power;
    }

    /** The text of a multiple of a step, with the decimals that distinguish it from the next one. */
    static String label(double value, double step) {
        if (value == 0) {
            return "0";
        }
        boolean isLarge = step >= 1000;
        double shown = isLarge ? value / 1000 : value;
        int decimals = (int) Math.max(0, Math.ceil(-Math.log10(isLarge ? step / 1000 : step) - 1e-9));
        return String.format(Locale.ROOT, "%." + decimals + "f%s", shown, isLarge ? "k" : "");
    }

    /** A coordinate with one decimal. */
    static String number(double value) {
        return String.format(Locale.ROOT, "%.1f", value);
    }
}
