package io.github.sofas.experiments;

import io.github.sofas.render.Panel;
import java.util.List;
import java.util.Map;

/**
 * Pictures of the labels of a method at some moments of a film, as in the paper's last figure.
 *
 * @param fullPxPerS speed of the full colour, and of an arrow as long as a fifth of a picture's width, in px/s
 * @param moments the moments, in order of time
 * @param withLegends the last moment with titles and legends
 */
record Strip(double fullPxPerS, List<Moment> moments, Picture withLegends) {
    /** The panels of each moment. */
    static final List<Panel> PANELS = List.of(Panel.FLOW, Panel.SEGMENTS, Panel.CONTOURS);

    /**
     * The pictures at a moment.
     *
     * @param timeUs time of the moment in µs
     * @param pictures the picture of each panel, without title and legend
     */
    record Moment(long timeUs, Map<Panel, Picture> pictures) {
    }
}
