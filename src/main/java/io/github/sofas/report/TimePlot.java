package io.github.sofas.report;

import static j2html.TagCreator.figcaption;
import static j2html.TagCreator.tag;

import j2html.TagCreator;
import j2html.tags.ContainerTag;
import j2html.tags.DomContent;
import java.util.Locale;
import java.util.function.IntToDoubleFunction;

/** A plot of curves over the time of the recording. */
final class TimePlot {
    /** Ends of the axis of directions, in degrees; no other axis begins below 0. */
    static final int HALF_TURN = 180;
    private static final int HEIGHT = 200;
    private static final int TOP = 8;

    private final String caption;
    private final double durationS;
    private final double stepS;
    private final double low;
    private final double high;
    private final ContainerTag<?> drawing;

    /**
     * Makes an empty plot.
     *
     * @param stepS time between two values of a curve
     * @param low lower end of the value axis
     * @param high greatest value; the axis ends at the next round one
     */
    TimePlot(String title, double durationS, double stepS, double low, double high, String unit) {
        caption = title + ", " + unit;
        this.durationS = durationS;
        this.stepS = stepS;
        this.low = low;
        // steps of the axis: quarters of a turn for directions, otherwise round numbers that reach the greatest value
        double step = low == -HALF_TURN ? HALF_TURN / 2.0 : Svg.roundStep(high > low ? high - low : 1);
        int steps = (int) Math.max(1, Math.ceil((high - low) / step - 1e-9));
        this.high = low + steps * step;
        drawing = Svg.drawing("plot", "0 0 " + Svg.WIDTH + " " + HEIGHT, title)
            .attr("data-to", durationS).attr("data-low", low).attr("data-high", this.high).attr("data-unit", unit);
        for (int i = 0; i <= steps; i++) {
            double value = low + i * step;
            drawing.with(tag("path").attr("class", "rule")
                .attr("d", "M" + Svg.LEFT + " " + Svg.number(y(value)) + "H" + Svg.WIDTH),
                Svg.text(Svg.LEFT - 6, y(value) + 4, "end", Svg.label(value, step)));
        }
        Svg.addTimeAxis(drawing, durationS, HEIGHT - Svg.BOTTOM);
    }

    /** Adds a curve of values that begins at a time step. NaN makes a gap. */
    TimePlot curve(String name, String style, int first, int count, IntToDoubleFunction value) {
        StringBuilder d = new StringBuilder();
        boolean pen = false;
        double last = 0;
        for (int i = 0; i < count; i++) {
            double v = value.applyAsDouble(i);
            if (Double.isNaN(v)) {
                pen = false;
                continue;
            }
            // -180 and 180 degrees are the same direction: no line joins them
            pen &= low != -HALF_TURN || Math.abs(v - last) <= HALF_TURN;
            last = v;
            // a single point is a line of zero length, which round ends turn into a dot
            d.append(String.format(Locale.ROOT, pen ? "L%.1f %.1f" : "M%1$.1f %2$.1fL%1$.1f %2$.1f",
                Svg.x((first + i + 0.5) * stepS, durationS), y(v)));
            pen = true;
        }
        drawing.with(Svg.path("line " + style, d.toString(), name));
        return this;
    }

    private double y(double value) {
        return HEIGHT - Svg.BOTTOM - (HEIGHT - Svg.BOTTOM - TOP) * (high > low ? (value - low) / (high - low) : 0);
    }

    /** The plot with its caption. */
    DomContent figure() {
        return TagCreator.figure(figcaption(caption), drawing);
    }
}
