package io.github.sofas.render;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.GreyFrame;
import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.flow.Segment;
import io.github.sofas.flow.Sofas;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;

/**
 * Paints labelled events: panels with titles and legends, the time, and arrows. Of every pixel the last event is
 * remembered; a picture shows those that are still exposed. One thread at a time.
 */
public final class PictureSheet {
    /** Fewest exposed pixels of a segment that is named and gets an arrow: fewer are specks. */
    private static final int LEAST_PIXELS = 12;

    private final SensorSize sensor;
    private final List<Panel> panels;
    private final Theme theme;
    private final FlowColours flowColours;
    private final SegmentColours segmentColours;
    private final SegmentNames segmentNames;
    private final PanelLayout layout;
    private final LastEvents last;
    private final SpeedScale speed;
    private final SeenSegments seen = new SeenSegments();

    /** Pixels that the picture shows, where in a panel, and the place of their segment among those seen. */
    private final int[] exposed;
    private final int[] exposedPlace;
    private final int[] exposedSegment;
    private int exposedPixels;

    /** Null before the first one. */
    private GreyFrame frame;

    private final Canvas canvas;
    private final PanelGround ground;
    private final TimeStamp timeStamp;

    /**
     * Makes a sheet on which nothing has been seen.
     *
     * @param sensor size of the sensor
     * @param options what a picture shows
     * @throws IllegalArgumentException where the crop is not on the sensor, or a picture would have more than 9.4
     *     million pixels
     */
    public PictureSheet(SensorSize sensor, PictureOptions options) {
        this.sensor = sensor;
        panels = options.panels();
        theme = options.theme();
        flowColours = new FlowColours(options.wheel(), theme);
        segmentColours = new SegmentColours(theme);
        segmentNames = new SegmentNames(theme.sensor, theme.text);
        layout = new PanelLayout(sensor, options);
        last = new LastEvents(sensor, options.exposureUs(), options.exposureEvents());
        speed = new SpeedScale(options.fullPxPerS());
        int n = sensor.width() * sensor.height();
        exposed = new int[n];
        exposedPlace = new int[n];
        exposedSegment = new int[n];
        canvas = new Canvas(layout.width(), layout.height());
        ground = new PanelGround(canvas, layout, panels, theme, flowColours);
        timeStamp = new TimeStamp(theme.text);
    }

    /**
     * Gives a segment the colour of {@link Theme#segmentColour}, which it would else get when it is first painted.
     *
     * @param segmentId of the segment
     * @param place of the colour, from 0
     */
    public void colour(int segmentId, int place) {
        segmentColours.assign(segmentId, place);
    }

    /**
     * Takes the events from one place of a batch to before another; those outside the sensor are passed over.
     *
     * @param batch the events
     * @param flow their labels
     * @param from first of them
     * @param to after the last of them
     */
    public void add(EventBatch batch, FlowOutput flow, int from, int to) {
        last.add(batch, flow, from, to);
    }

    /**
     * Takes the frame that {@link Panel#GREY} shows from now on.
     *
     * @param newFrame of the sensor's size
     * @throws IllegalArgumentException where it is not of the sensor's size
     */
    public void show(GreyFrame newFrame) {
        if (newFrame.width() != sensor.width() || newFrame.height() != sensor.height()) {
            throw new IllegalArgumentException("frame must be of the sensor's size " + sensor + " but was "
                + newFrame.width() + "x" + newFrame.height());
        }
        frame = newFrame;
    }

    /**
     * Paints what is exposed at a time.
     *
     * @param timeUs not before the last event taken
     * @param shownUs the time that is written, µs since the recording's start
     * @param engine whose contours are painted; null for none
     * @return the same image at every call, painted over by the next one
     */
    public BufferedImage paint(long timeUs, long shownUs, Sofas engine) {
        survey(timeUs);
        canvas.wipe();
        ground.paint(speed.fullPxPerS());
        for (int k = 0; k < panels.size(); k++) {
            if (panels.get(k) == Panel.GREY) {
                paintFrame(k);
            } else {
                paintEvents(k);
            }
        }
        for (int k = 0; k < panels.size(); k++) {
            Panel panel = panels.get(k);
            if (panel == Panel.CONTOURS && engine != null) {
                paintContours(k, engine);
            }
            if (panel == Panel.SEGMENTS || panel == Panel.CONTOURS) {
                paintArrows(k);
            }
        }
        timeStamp.paint(canvas, shownUs, layout.left(0) + layout.panelWidth(), layout.top(0) - PanelLayout.BASELINE);
        return canvas.image();
    }

    /**
     * {@return one panel of the last picture, without title and legend; a part of that picture, not a copy}
     *
     * @param k place among the panels, from 0
     */
    public BufferedImage panel(int k) {
        return canvas.image().getSubimage(layout.left(k), layout.top(k), layout.panelWidth(), layout.panelHeight());
    }

    /**
     * {@return what explains one panel, below it in the last picture; a part of that picture, not a copy}
     *
     * @param k place among the panels, from 0
     */
    public BufferedImage legend(int k) {
        return canvas.image().getSubimage(layout.left(k), layout.top(k) + layout.panelHeight(), layout.panelWidth(),
            PanelLayout.LEGEND);
    }

    /** Sees which pixels and segments are exposed, and how fast all is. */
    private void survey(long timeUs) {
        seen.clear();
        speed.clear();
        exposedPixels = 0;
        int count = last.exposed(timeUs, exposed);
        for (int i = 0; i < count; i++) {
            expose(exposed[i]);
        }
        segmentColours.assign(seen);
        speed.follow();
    }

    /** Takes a pixel that is exposed; segments and speeds are those of the whole sensor. */
    private void expose(int at) {
        int x = at % sensor.width();
        int y = at / sensor.width();
        int seenSegment = 0;
        if (last.segment(at) != 0) {
            seenSegment = seen.add(last.segment(at), x, y, last.vx(at), last.vy(at));
            speed.add(last.vx(at), last.vy(at));
        }
        if (layout.shows(x, y)) {
            exposed[exposedPixels] = at;
            exposedSegment[exposedPixels] = seenSegment;
            exposedPlace[exposedPixels++] = layout.within(x, y);
        }
    }

    private void paintFrame(int k) {
        if (frame == null) {
            return;
        }
        int[] grey = GreyScale.of(frame);
        PictureOptions.Crop crop = layout.crop();
        for (int y = crop.y(); y < crop.y() + crop.height(); y++) {
            for (int x = crop.x(); x < crop.x() + crop.width(); x++) {
                canvas.fill(layout.corner(k) + layout.within(x, y), layout.scale(), grey[frame.level(x, y)]);
            }
        }
    }

    private void paintEvents(int k) {
        Panel panel = panels.get(k);
        int[] colours = new int[seen.size()];
        for (int i = 0; i < colours.length; i++) {
            colours[i] = segmentColours.rgb(seen.id(i));
        }
        int corner = layout.corner(k);
        int scale = layout.scale();
        for (int i = 0; i < exposedPixels; i++) {
            canvas.fill(corner + exposedPlace[i], scale, colour(panel, exposed[i], exposedSegment[i], colours));
        }
    }

    /** The colour of a pixel's event, of one of the segments seen, whose colours are given. */
    private int colour(Panel panel, int at, int seenSegment, int[] colours) {
        if (panel == Panel.EVENTS) {
            return last.polarity(at) > 0 ? theme.on : theme.off;
        } else if (last.segment(at) == 0 || panel == Panel.CONTOURS) {
            return theme.faint;
        }
        return panel == Panel.FLOW ? flowColours.rgb(last.vx(at), last.vy(at), speed.fullPxPerS())
            : colours[seenSegment];
    }

    private void paintContours(int k, Sofas engine) {
        for (Segment each : engine.segments()) {
            int rgb = segmentColours.rgb(each.id());
            engine.contour(each.id(), (x, y) -> {
                if (layout.shows(x, y)) {
                    canvas.fill(layout.corner(k) + layout.within(x, y), layout.scale(), rgb);
                }
            });
        }
    }

    /** Names the segments, each with an arrow on the scale of the legend's bar. */
    private void paintArrows(int k) {
        List<SegmentArrow> arrows = new ArrayList<>();
        Rectangle panel = layout.panel(k);
        PictureOptions.Crop crop = layout.crop();
        double perPxPerS = layout.barLength() / speed.fullPxPerS();
        for (int i = 0; i < seen.size(); i++) {
            double x = panel.x + (seen.x(i) - crop.x() + 0.5) * layout.scale();
            double y = panel.y + (seen.y(i) - crop.y() + 0.5) * layout.scale();
            if (seen.pixels(i) >= LEAST_PIXELS && panel.contains(x, y)) {
                arrows.add(new SegmentArrow(seen.id(i), segmentColours.rgb(seen.id(i)), seen.pixels(i), x, y,
                    seen.vx(i) * perPxPerS, seen.vy(i) * perPxPerS));
            }
        }
        SegmentArrow.paint(canvas, panel, arrows, theme, segmentNames);
    }
}
