package io.github.sofas.render;

import java.util.List;

/**
 * The options of a picture: which panels it shows, of which events and which part of the sensor, and how.
 *
 * @param panels panels from left to right, two per row; each at most once
 * @param theme dark or light
 * @param wheel colours of directions
 * @param scale screen pixels per pixel of the sensor, 1 to 16; 0 for the smallest that makes a panel at least 480 px
 *     wide
 * @param exposureUs time for which an event is shown, µs; 0 if {@code exposureEvents} applies
 * @param exposureEvents number of newest events shown; 0 if {@code exposureUs} applies
 * @param fullPxPerS speed of the full colour in px/s; 0 for a speed that follows the events shown, upwards only
 * @param crop part of the sensor that is shown; null for all of it
 */
public record PictureOptions(List<Panel> panels, Theme theme, FlowColours.Wheel wheel, int scale, long exposureUs,
                             long exposureEvents, double fullPxPerS, Crop crop) {

    /**
     * A part of the sensor.
     *
     * @param x leftmost column
     * @param y topmost row
     * @param width columns
     * @param height rows
     */
    public record Crop(int x, int y, int width, int height) {
    }

    /**
     * Checks the options.
     *
     * @param panels panels from left to right, two per row; each at most once
     * @param theme dark or light
     * @param wheel colours of directions
     * @param scale screen pixels per pixel of the sensor, 1 to 16; 0 for the smallest that makes a panel at least 480
     *     px wide
     * @param exposureUs time for which an event is shown, µs; 0 if {@code exposureEvents} applies
     * @param exposureEvents number of newest events shown; 0 if {@code exposureUs} applies
     * @param fullPxPerS speed of the full colour in px/s; 0 for a speed that follows the events shown, upwards only
     * @param crop part of the sensor that is shown; null for all of it
     * @throws IllegalArgumentException if an option is out of range
     */
    public PictureOptions {
        panels = List.copyOf(panels);
        if (panels.isEmpty() || panels.stream().distinct().count() < panels.size()) {
            throw new IllegalArgumentException("panels must be one or more, each once, but were " + panels);
        }
        if (scale < 0 || scale > 16) {
            throw new IllegalArgumentException("scale must be between 0 and 16 but was " + scale);
        }
        if (exposureUs < 0 || exposureEvents < 0 || exposureUs > 0 == exposureEvents > 0) {
            throw new IllegalArgumentException("either exposureUs or exposureEvents must be above 0 but they were "
                + exposureUs + " and " + exposureEvents);
        }
        if (!(fullPxPerS >= 0 && fullPxPerS <= 1e6)) {
            throw new IllegalArgumentException("fullPxPerS must be between 0 and 1,000,000 but was " + fullPxPerS);
        }
    }

    /** {@return options for flow and segments on dark ground, with the events of the last 33 ms} */
    public static PictureOptions defaults() {
        return new PictureOptions(List.of(Panel.FLOW, Panel.SEGMENTS), Theme.DARK, FlowColours.Wheel.SAFE, 0, 33_333, 0,
            0, null);
    }

    /**
     * {@return these options with other panels}
     *
     * @param newPanels one panel or more, each once
     */
    public PictureOptions withPanels(List<Panel> newPanels) {
        return new PictureOptions(newPanels, theme, wheel, scale, exposureUs, exposureEvents, fullPxPerS, crop);
    }

    /**
     * {@return these options with another scale}
     *
     * @param newScale screen pixels per pixel of the sensor; 0 for the smallest that makes a panel at least 480 px wide
     */
    public PictureOptions withScale(int newScale) {
        return new PictureOptions(panels, theme, wheel, newScale, exposureUs, exposureEvents, fullPxPerS, crop);
    }
}
