package io.github.sofas.render;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.GreyFrame;
import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.flow.Segment;
import io.github.sofas.flow.Sofas;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.geom.Line2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/**
 * Paints labelled events: panels with titles and legends, the time, and arrows. Of every pixel the last event is
 * remembered; a picture shows those that are still exposed. One thread at a time.
 */
public final class PictureSheet {
    private static final int LEAST_WIDTH = 480;
    private static final int MARGIN = 8;
    private static final int TITLE = 24;
    private static final int LEGEND = 64;
    /** Video codecs take whole blocks of 16 x 16 pixels. */
    private static final int BLOCK = 16;
    /** Those of level 5.1 of H.264, which players decode: 36,864 blocks, such as 4096 x 2304. */
    private static final int MOST_PIXELS = 36_864 * BLOCK * BLOCK;
    /** Fewest exposed pixels of a segment that is named and gets an arrow: fewer are specks. */
    private static final int LEAST_PIXELS = 12;
    /** Speeds that the full colour may stand for, px/s. */
    private static final int[] SPEEDS = {1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10_000, 20_000, 50_000,
        100_000};

    /** What a picture's speeds count for after the next one. */
    private static final double FADING = 0.95;

    private final SensorSize sensor;
    private final PictureOptions options;
    private final Theme theme;
    private final FlowColours flowColours;
    private final SegmentColours segmentColours;
    private final SegmentNames segmentNames;
    private final PictureOptions.Crop crop;
    private final int scale;

    // the last event of every pixel
    private final long[] seenUs;
    private final long[] number;
    private final byte[] polarity;
    private final float[] vx;
    private final float[] vy;
    private final int[] segment;
    private long events;
    /** Pixels in the order of their events; only a pixel's last place, which is remembered beside, counts. */
    private final int[] order;
    private final int[] place;
    private int ordered;
    /** Pixels that the picture shows, where in a panel, and the place of their segment among those seen. */
    private final int[] exposed;
    private final int[] exposedPlace;
    private final int[] exposedSegment;
    private int exposedPixels;

    /** Null before the first one. */
    private GreyFrame frame;

    private double fullPxPerS;
    /** How many pixels are as fast as each of {@link #SPEEDS}. */
    private final int[] speeds = new int[SPEEDS.length];
    /** The same of the last pictures, each of which counts less than the one after it. */
    private final double[] recentSpeeds = new double[SPEEDS.length];
    private final SeenSegments seen = new SeenSegments();

    private final Canvas canvas;
    private final TimeStamp timeStamp;
    private final int width;
    /** What the legends on the canvas's ground say; 0 before the first. */
    private double groundFullPxPerS;

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
        this.options = options;
        theme = options.theme();
        flowColours = new FlowColours(options.wheel(), theme);
        segmentColours = new SegmentColours(theme);
        segmentNames = new SegmentNames(theme.sensor, theme.text);
        crop = options.crop() != null ? options.crop()
            : new PictureOptions.Crop(0, 0, sensor.width(), sensor.height());
        if (crop.width() < 1 || crop.height() < 1 || !sensor.contains(crop.x(), crop.y())
                || !sensor.contains(crop.x() + crop.width() - 1, crop.y() + crop.height() - 1)) {
            throw new IllegalArgumentException("crop must lie on the sensor of " + sensor + " but was "
                + crop.x() + "," + crop.y() + "," + crop.width() + "," + crop.height());
        }
        scale = options.scale() > 0 ? options.scale() : (LEAST_WIDTH + crop.width() - 1) / crop.width();
        fullPxPerS = options.fullPxPerS() > 0 ? options.fullPxPerS() : 20;
        int n = sensor.width() * sensor.height();
        seenUs = new long[n];
        number = new long[n];
        polarity = new byte[n];
        vx = new float[n];
        vy = new float[n];
        segment = new int[n];
        order = new int[2 * n];
        place = new int[n];
        exposed = new int[n];
        exposedPlace = new int[n];
        exposedSegment = new int[n];
        int columns = Math.min(2, options.panels().size());
        int rows = (options.panels().size() + 1) / 2;
        width = blocks(columns * (panelWidth() + MARGIN) + MARGIN);
        int height = blocks(rows * (TITLE + panelHeight() + LEGEND));
        if ((long) width * height > MOST_PIXELS) {
            throw new IllegalArgumentException("a picture must have at most " + MOST_PIXELS + " pixels but would be "
                + width + "x" + height + ": take a smaller scale or fewer panels");
        }
        canvas = new Canvas(width, height);
        timeStamp = new TimeStamp(theme.text);
    }

    private static int blocks(int size) {
        return (size + BLOCK - 1) / BLOCK * BLOCK;
    }

    private int panelWidth() {
        return crop.width() * scale;
    }

    private int panelHeight() {
        return crop.height() * scale;
    }

    /** Left side of a panel, in screen pixels. */
    private int left(int panel) {
        return MARGIN + panel % 2 * (panelWidth() + MARGIN);
    }

    private int top(int panel) {
        return TITLE + panel / 2 * (TITLE + panelHeight() + LEGEND);
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
        int columns = sensor.width();
        for (int i = from; i < to; i++) {
            int x = batch.x[i];
            int y = batch.y[i];
            if (sensor.contains(x, y)) {
                int at = y * columns + x;
                seenUs[at] = batch.timeUs[i];
                number[at] = events++;
                polarity[at] = batch.polarity[i];
                vx[at] = flow.vxPxPerS[i];
                vy[at] = flow.vyPxPerS[i];
                segment[at] = flow.segment[i];
                if (ordered == order.length) {
                    forgetEarlierPlaces();
                }
                place[at] = ordered;
                order[ordered++] = at;
            }
        }
    }

    private void forgetEarlierPlaces() {
        int kept = 0;
        for (int i = 0; i < ordered; i++) {
            int at = order[i];
            if (place[at] == i) {
                place[at] = kept;
                order[kept++] = at;
            }
        }
        ordered = kept;
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
        if (groundFullPxPerS != fullPxPerS) {
            paintGround();
        }
        for (int k = 0; k < options.panels().size(); k++) {
            paintEvents(k);
        }
        for (int k = 0; k < options.panels().size(); k++) {
            Panel panel = options.panels().get(k);
            if (panel == Panel.CONTOURS && engine != null) {
                paintContours(k, engine);
            }
            if (panel == Panel.SEGMENTS || panel == Panel.CONTOURS) {
                paintArrows(k);
            }
        }
        timeStamp.paint(canvas, shownUs, left(0) + panelWidth(), TITLE - 7);
        return canvas.image();
    }

    /**
     * {@return one panel of the last picture, without title and legend; a part of that picture, not a copy}
     *
     * @param k place among the panels, from 0
     */
    public BufferedImage panel(int k) {
        return canvas.image().getSubimage(left(k), top(k), panelWidth(), panelHeight());
    }

    /**
     * {@return what explains one panel, below it in the last picture; a part of that picture, not a copy}
     *
     * @param k place among the panels, from 0
     */
    public BufferedImage legend(int k) {
        return canvas.image().getSubimage(left(k), top(k) + panelHeight(), panelWidth(), LEGEND);
    }

    private boolean isExposed(int at, long timeUs) {
        return options.exposureUs() > 0 ? timeUs - seenUs[at] < options.exposureUs()
            : events - number[at] <= options.exposureEvents();
    }

    /** Sees which pixels and segments are exposed, and how fast all is. */
    private void survey(long timeUs) {
        seen.clear();
        Arrays.fill(speeds, 0);
        exposedPixels = 0;
        for (int i = ordered - 1; i >= 0 && isExposed(order[i], timeUs); i--) {
            if (place[order[i]] == i) {
                expose(order[i]);
            }
        }
        segmentColours.assign(seen);
        followSpeed();
    }

    /** Lets the full colour stand for the speed that nine tenths of the pixels do not pass, of the last pictures. */
    private void followSpeed() {
        double withFlow = 0;
        for (int k = 0; k < speeds.length; k++) {
            recentSpeeds[k] = FADING * recentSpeeds[k] + speeds[k];
            withFlow += recentSpeeds[k];
        }
        if (options.fullPxPerS() == 0 && withFlow >= LEAST_PIXELS) {
            double below = 0;
            int k = 0;
            while (k < SPEEDS.length - 1 && below + recentSpeeds[k] < 0.9 * withFlow) {
                below += recentSpeeds[k++];
            }
            fullPxPerS = Math.max(fullPxPerS, SPEEDS[k]);
        }
    }

    /** Takes a pixel that is exposed. */
    private void expose(int at) {
        int x = at % sensor.width();
        int y = at / sensor.width();
        if (segment[at] != 0) {
            exposedSegment[exposedPixels] = seen.add(segment[at], x, y, vx[at], vy[at]);
            speeds[step(vx[at] * vx[at] + vy[at] * vy[at])]++;
        }
        int column = x - crop.x();
        int row = y - crop.y();
        if (column >= 0 && column < crop.width() && row >= 0 && row < crop.height()) {
            exposed[exposedPixels] = at;
            exposedPlace[exposedPixels++] = (row * width + column) * scale;
        }
    }

    /** Least of {@link #SPEEDS} that is not below a speed, whose square is given. */
    private static int step(float square) {
        int k = 0;
        while (k < SPEEDS.length - 1 && SPEEDS[k] * (float) SPEEDS[k] < square) {
            k++;
        }
        return k;
    }

    private void paintFrame(int k) {
        int[] grey = GreyScale.of(frame);
        for (int row = 0; row < crop.height(); row++) {
            int to = (top(k) + row * scale) * width + left(k);
            for (int column = 0; column < crop.width(); column++, to += scale) {
                canvas.fill(to, scale, grey[frame.level(crop.x() + column, crop.y() + row)]);
            }
        }
    }

    private void paintEvents(int k) {
        Panel panel = options.panels().get(k);
        if (panel == Panel.GREY) {
            if (frame != null) {
                paintFrame(k);
            }
            return;
        }
        int[] colours = new int[seen.size()];
        for (int i = 0; i < colours.length; i++) {
            colours[i] = segmentColours.rgb(seen.id(i));
        }
        int corner = top(k) * width + left(k);
        for (int i = 0; i < exposedPixels; i++) {
            canvas.fill(corner + exposedPlace[i], scale, colour(panel, exposed[i], exposedSegment[i], colours));
        }
    }

    /** The colour of a pixel's event, of one of the segments seen, whose colours are given. */
    private int colour(Panel panel, int at, int seenSegment, int[] colours) {
        if (panel == Panel.EVENTS) {
            return polarity[at] > 0 ? theme.on : theme.off;
        } else if (segment[at] == 0 || panel == Panel.CONTOURS) {
            return theme.faint;
        }
        return panel == Panel.FLOW ? flowColours.rgb(vx[at], vy[at], fullPxPerS) : colours[seenSegment];
    }

    private void paintContours(int k, Sofas engine) {
        for (Segment each : engine.segments()) {
            int rgb = segmentColours.rgb(each.id());
            engine.contour(each.id(), (x, y) -> {
                int column = x - crop.x();
                int row = y - crop.y();
                if (column >= 0 && column < crop.width() && row >= 0 && row < crop.height()) {
                    canvas.fill((top(k) + row * scale) * width + left(k) + column * scale, scale, rgb);
                }
            });
        }
    }

    /** Names the segments, each with an arrow on the scale of the legend's bar. */
    private void paintArrows(int k) {
        List<SegmentArrow> arrows = new ArrayList<>();
        Rectangle panel = new Rectangle(left(k), top(k), panelWidth(), panelHeight());
        double perPxPerS = barLength() / fullPxPerS;
        for (int i = 0; i < seen.size(); i++) {
            double x = left(k) + (seen.x(i) - crop.x() + 0.5) * scale;
            double y = top(k) + (seen.y(i) - crop.y() + 0.5) * scale;
            if (seen.pixels(i) >= LEAST_PIXELS && panel.contains(x, y)) {
                arrows.add(new SegmentArrow(seen.id(i), segmentColours.rgb(seen.id(i)), seen.pixels(i), x, y,
                    seen.vx(i) * perPxPerS, seen.vy(i) * perPxPerS));
            }
        }
        SegmentArrow.paint(canvas, panel, arrows, theme, segmentNames);
    }

    /** Length of the arrow of the full speed, in screen pixels. */
    private double barLength() {
        return Math.min(100, panelWidth() / 4.0);
    }

    /** Draws with smooth edges. */
    static Graphics2D graphics(BufferedImage image) {
        Graphics2D g = image.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        return g;
    }

    /** Titles, legends and empty panels, which stay from picture to picture. */
    private void paintGround() {
        BufferedImage picture = canvas.image();
        Graphics2D g = graphics(picture);
        g.setColor(new Color(theme.page));
        g.fillRect(0, 0, picture.getWidth(), picture.getHeight());
        for (int k = 0; k < options.panels().size(); k++) {
            Panel panel = options.panels().get(k);
            g.setColor(new Color(theme.sensor));
            g.fillRect(left(k), top(k), panelWidth(), panelHeight());
            g.setColor(new Color(theme.text));
            g.setFont(new Font(Font.SANS_SERIF, Font.BOLD, 14));
            g.drawString(panel.title, left(k), top(k) - 7);
            g.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 12));
            if (panel == Panel.GREY) {
                // frames cover it
                g.drawString("no frame so far", left(k) + MARGIN, top(k) + 2 * MARGIN);
            }
            paintLegend(g, panel, left(k), top(k) + panelHeight() + 6);
        }
        g.dispose();
        canvas.keepAsGround();
        groundFullPxPerS = fullPxPerS;
    }

    private void paintLegend(Graphics2D g, Panel panel, int x, int y) {
        String full = String.format(Locale.ROOT, "%.0f px/s", fullPxPerS);
        switch (panel) {
            case EVENTS:
                swatch(g, x, y, theme.on, "brighter (ON)");
                swatch(g, x, y + 20, theme.off, "darker (OFF)");
                break;
            case FLOW:
                paintWheel(x + 24, y + 25, 24);
                g.setColor(new Color(theme.text));
                g.drawString("colour: direction of the flow", x + 58, y + 16);
                g.drawString("full colour: " + full + " or more", x + 58, y + 32);
                swatch(g, x + 58, y + 36, theme.faint, "no flow");
                break;
            case GREY:
                g.setColor(new Color(theme.text));
                g.drawString("the newest frame, its contrast stretched", x, y + 12);
                break;
            default:
                g.setColor(new Color(theme.text));
                g.drawString(panel == Panel.SEGMENTS ? "a colour and a number: one moving structure"
                    : "where each structure's next events are expected", x, y + 12);
                SegmentArrow.draw(canvas, canvas.image().getRaster().getBounds(),
                    new Line2D.Double(x + 2, y + 28, x + 2 + barLength(), y + 28), SegmentArrow.WIDTH, theme.text);
                g.drawString(full, (int) (x + barLength() + 12), y + 33);
                swatch(g, x, y + 38, theme.faint, panel == Panel.SEGMENTS ? "no segment" : "events");
                break;
        }
    }

    private void swatch(Graphics2D g, int x, int y, int rgb, String text) {
        g.setColor(new Color(rgb));
        g.fillRect(x, y + 3, 12, 12);
        g.setColor(new Color(theme.text));
        g.drawString(text, x + 18, y + 14);
    }

    private void paintWheel(int centreX, int centreY, int radius) {
        for (int dy = -radius; dy <= radius; dy++) {
            for (int dx = -radius; dx <= radius; dx++) {
                if (dx * dx + dy * dy <= radius * radius) {
                    canvas.fill((centreY + dy) * width + centreX + dx, 1, flowColours.rgb(dx, dy, radius));
                }
            }
        }
    }
}
