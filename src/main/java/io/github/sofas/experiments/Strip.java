package io.github.sofas.experiments;

import io.github.sofas.render.Panel;
import java.util.List;
import java.util.Map;

/**
 * Pictures of what a method sees at some moments of a film, as in the paper's last figure.
 *
 * @param fullPxPerS speed of the full colour, and of an arrow a fifth of a picture's width, in px/s
 * @param moments in order of time
 * @param withLegends the last moment with titles and legends
 */
record Strip(double fullPxPerS, List<Moment> moments, Picture withLegends) {
    /** What is pictured. */
    static final List<Panel> PANELS = List.of(Panel.FLOW, Panel.SEGMENTS, Panel.CONTOURS);

    /**
     * What is seen at a moment.
     *
     * @param timeUs when
     * @param pictures of each panel, without title and legend
     */
    record Moment(long timeUs, Map<Panel, Picture> pictures) {
    }
}
