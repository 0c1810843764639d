package io.github.sofas.report;

import static j2html.TagCreator.tag;

import j2html.tags.ContainerTag;
import j2html.tags.DomContent;

/** A plot of when each segment lived: one bar per segment, one below the other. */
final class LifeLines {
    private static final int ROW = 14;

    private final double durationS;
    private final int height;
    private final ContainerTag<?> drawing;
    private int rows;

    LifeLines(double durationS, int count) {
        this.durationS = durationS;
        height = count * ROW + Svg.BOTTOM;
        drawing = Svg.drawing("plot lives", "0 0 " + Svg.WIDTH + " " + height, "life lines of the segments")
            .attr("data-to", durationS);
    }

    /** Adds the next bar. {@code said} is the text that is shown on hover. */
    void add(int id, double fromS, double toS, String colour, String said) {
        double from = Svg.x(fromS, durationS);
        double to = Svg.x(toS, durationS);
        drawing.with(Svg.text(Svg.LEFT - 6, rows * ROW + 10, "end", Integer.toString(id)),
            tag("rect").attr("class", "life " + colour).attr("x", Svg.number(from)).attr("y", rows * ROW + 2)
                .attr("width", Svg.number(Math.max(2, to - from))).attr("height", 8).attr("rx", 2)
                .with(tag("title").withText(said)));
        rows++;
    }

    DomContent svg() {
        Svg.addTimeAxis(drawing, durationS, height - Svg.BOTTOM);
        return drawing;
    }
}
