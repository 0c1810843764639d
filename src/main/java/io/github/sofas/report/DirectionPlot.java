package io.github.sofas.report;

import static j2html.TagCreator.tag;

import j2html.tags.ContainerTag;
import j2html.tags.DomContent;
import java.util.Arrays;
import java.util.Locale;

/** A plot of how many events move in each direction: a rose with one petal per direction. */
final class DirectionPlot {
    private static final double RADIUS = 100;

    private final long[] counts;
    private final long all;
    private final long most;

    /** Takes the counts of directions, which start at right and turn to up. */
    DirectionPlot(long[] counts) {
        this.counts = counts;
        all = Arrays.stream(counts).sum();
        most = Arrays.stream(counts).max().orElse(0);
    }

    boolean isEmpty() {
        return all == 0;
    }

    /** The angle from right to down, -180 to 180 degrees: y points down, as in all result files. */
    private static double downwardsDeg(double upwards) {
        double turned = -Math.toDegrees(upwards);
        return turned <= -180 ? turned + 360 : turned + 0.0;
    }

    DomContent svg() {
        ContainerTag<?> drawing = Svg.drawing("polar", "-130 -120 260 240", "directions of flow")
            .with(tag("circle").attr("r", "100"), tag("circle").attr("r", "50"));
        for (int d = 0; d < counts.length; d++) {
            double r = RADIUS * counts[d] / most;
            double half = Math.PI / counts.length;
            double at = 2 * d * half;
            drawing.with(Svg.path("", String.format(Locale.ROOT, "M0 0L%.2f %.2fL%.2f %.2fZ", r * Math.cos(at - half),
                -r * Math.sin(at - half), r * Math.cos(at + half), -r * Math.sin(at + half)),
                String.format(Locale.ROOT, "%.0f°: %.1f %%", downwardsDeg(at), 100.0 * counts[d] / all)));
        }
        return drawing.with(Svg.text(104, 4, "", "right"), Svg.text(0, -105, "middle", "up"),
            Svg.text(-104, 4, "end", "left"), Svg.text(0, 115, "middle", "down"),
            Svg.text(74, -74, "", String.format(Locale.ROOT, "%.0f %%", 100.0 * most / all)));
    }
}
