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
 * Paints labelled events as pictures: panels with titles and legends, the time, and velocity arrows. The sheet
 * remembers the last event of every pixel. A picture shows those of these events that are still exposed. For one thread
 * at a time.
 */
public final class PictureSheet {
    /** Fewest exposed pixels of a segment that gets a name and an arrow; smaller segments are specks. */
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

    /** Pixels that the picture shows, their offsets in a panel, and the index of their segment in {@link #seen}. */
    private final int[] exposed;
    private final int[] exposedPlace;
    private final int[] exposedSegment;
    private int exposedPixels;

    /** The frame shown; null before the first one. */
    private GreyFrame frame;

    private final Canvas canvas;
    private final PanelGround ground;
    private final TimeStamp timeStamp;

    /**
     * Makes a sheet without events.
     *
     * @param sensor size of the sensor
     * @param options what a picture shows
     * @throws IllegalArgumentException if the crop is not on the sensor, or if a picture would have more than 9.4
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
     * Gives a segment a colour of {@link Theme#segmentColour}. Without this call, the segment gets a colour when it is
     * first painted.
     *
     * @param segmentId id of the segment
     * @param place index of the colour, from 0
     */
    public void colour(int segmentId, int place) {
        segmentColours.assign(segmentId, place);
    }

    /**
     * Takes the events of a batch from one index to before another. Events outside the sensor are skipped.
     *
     * @param batch the events
     * @param flow their labels
     * @param from index of the first event
     * @param to index after the last event
     */
    public void add(EventBatch batch, FlowOutput flow, int from, int to) {
        last.add(batch, flow, from, to);
    }

    /**
     * Takes the frame that {@link Panel#GREY} shows from now on.
     *
     * @param newFrame a frame of the sensor's size
     * @throws IllegalArgumentException if the frame is not of the sensor's size
     */
    public void show(GreyFrame newFrame) {
        if (newFrame.width() != sensor.width() || newFrame.height() != sensor.height()) {
            throw new IllegalArgumentException("frame must be of the sensor's size " + sensor + " but was "
                + newFrame.width() + "x" + newFrame.height());
        }
        frame = newFrame;
    }

    /**
     * Paints the events that are exposed at a time.
     *
     * @param timeUs not before the last event taken
     * @param shownUs the time that the picture shows as text, µs since the recording's start
     * @param engine engine whose contours are painted; null for none
     * @return the same image at every call; the next call paints over it
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
     * @param k index of the panel, from 0
     */
    public BufferedImage panel(int k) {
        return canvas.image().getSubimage(layout.left(k), layout.top(k), layout.panelWidth(), layout.panelHeight());
    }

    /**
     * {@return the legend of one panel, below it in the last picture; a part of that picture, not a copy}
     *
     * @param k index of the panel, from 0
     */
    public BufferedImage legend(int k) {
        return canvas.image().getSubimage(layout.left(k), layout.top(k) + layout.panelHeight(), layout.panelWidth(),
            PanelLayout.LEGEND);
    }

    /** Determines which pixels and segments are exposed, and the speed of the full colour. */
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

    /** Takes an exposed pixel. Segments and speeds are those of the whole sensor, not only of the crop. */
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

    /**
     * Colour of a pixel's event in a panel. {@code seenSegment} is the index of its segment in {@link #seen}, and
     * {@code colours} holds the colours of these segments.
     */
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

    /** Paints the names of the segments, each with an arrow at the scale of the legend's bar. */
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
