package io.github.sofas.experiments;

import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.flow.Segment;
import io.github.sofas.flow.Sofas;
import io.github.sofas.flow.SofasParameters;
import io.github.sofas.render.Theme;
import io.github.sofas.simulate.SimulatedRecording;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.AffineTransform;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Locale;

/**
 * Paints the method in four pictures, after the paper's figures: events on a projection along the time axis, the
 * metrics of the flow plane's projections, the events on the projection with the greatest metric, and the track planes
 * that follow.
 */
final class MethodPicture {
    private static final int SCALE = 2;
    private static final int MARGIN = 16;
    private static final int TITLE = 44;
    /** Time for which an event is shown on the contours, in µs. */
    private static final long EXPOSURE_US = 8_000;
    private static final Color TEXT = new Color(0x1D2125);
    private static final Color SOFT = new Color(0x5B646D);
    private static final Color GROUND = new Color(0xF5F6F8);
    private static final int ON = 0xC25500;
    private static final int OFF = 0x0050C0;
    /** Sum of the polarities in a cell, either way, from which the cell has the full colour. */
    private static final int FULL_CELL = 4;

    private final SimulatedRecording recording;
    private final long fromUs;
    private final long untilUs;
    private final MetricMap map;
    private final int width;
    private final int height;
    private final BufferedImage image;
    private final Graphics2D graphics;

    private MethodPicture(SimulatedRecording recording, long fromUs, long untilUs, MetricMap map) {
        this.recording = recording;
        this.fromUs = fromUs;
        this.untilUs = untilUs;
        this.map = map;
        width = SCALE * recording.sensor().width();
        height = SCALE * recording.sensor().height();
        image = new BufferedImage(3 * MARGIN + 2 * width, MARGIN + 2 * (TITLE + height + MARGIN),
            BufferedImage.TYPE_INT_RGB);
        graphics = image.createGraphics();
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        graphics.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    }

    /**
     * Paints the method at work on the events of a span of time.
     *
     * @param map the metrics of the same events
     */
    static Picture of(SimulatedRecording recording, long fromUs, long untilUs, MetricMap map) {
        MethodPicture picture = new MethodPicture(recording, fromUs, untilUs, map);
        picture.paint();
        picture.graphics.dispose();
        return Charts.of(picture.image, picture.image, "events, the metrics of the flow plane, the events on the best "
            + "projection, and track planes");
    }

    private void paint() {
        graphics.setColor(Color.WHITE);
        graphics.fillRect(0, 0, image.getWidth(), image.getHeight());
        List<MetricMap.Maximum> maxima = map.maxima(2, 2);
        MetricMap.Maximum best = maxima.get(0);
        int left = MARGIN;
        int right = 2 * MARGIN + width;
        int top = MARGIN;
        int bottom = MARGIN + TITLE + height + MARGIN;
        title(left, top, "1. Events of " + (untilUs - fromUs) / 1000 + " ms, projected along the time axis",
            "orange: brighter (ON), blue: darker (OFF); velocity 0, metric " + number(metric(0, 0)));
        projection(left, top + TITLE, 0, 0);
        title(right, top, "2. Flow plane: the metric of " + map.n() + " x " + map.n() + " projections",
            "darker is higher; one maximum per moving structure");
        metrics(right, top + TITLE, maxima);
        title(left, bottom, "3. The same events on the best projection",
            velocity(best.vxPxPerS(), best.vyPxPerS()) + ", metric " + number(best.metric())
            + ": what moves so falls on few cells");
        projection(left, bottom + TITLE, best.vxPxPerS(), best.vyPxPerS());
        title(right, bottom, "4. Track planes: contours and the events on them",
            "light: where events are expected; dark: those of the last " + EXPOSURE_US / 1000 + " ms");
        trackPlanes(right, bottom + TITLE);
    }

    private void title(int x, int y, String title, String below) {
        graphics.setColor(TEXT);
        graphics.setFont(new Font(Font.SANS_SERIF, Font.BOLD, 15));
        graphics.drawString(title, x, y + 14);
        graphics.setColor(SOFT);
        graphics.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 13));
        graphics.drawString(below, x, y + 33);
    }

    private static String number(long value) {
        return String.format(Locale.ROOT, "%,d", value);
    }

    private static String velocity(double vx, double vy) {
        return String.format(Locale.ROOT, "(%.0f, %.0f) px/s", vx, vy).replace("-0", "0");
    }

    /** The sum of the polarities in each cell of the sensor under a projection. */
    private int[] accumulator(double vx, double vy) {
        SensorSize sensor = recording.sensor();
        int[] cells = new int[sensor.width() * sensor.height()];
        for (int i = 0; i < recording.size(); i++) {
            if (recording.timeUs[i] >= fromUs && recording.timeUs[i] < untilUs) {
                double seconds = (recording.timeUs[i] - fromUs) * 1e-6;
                int x = (int) Math.round(recording.x[i] - vx * seconds);
                int y = (int) Math.round(recording.y[i] - vy * seconds);
                if (sensor.contains(x, y)) {
                    cells[y * sensor.width() + x] += recording.polarity[i];
                }
            }
        }
        return cells;
    }

    private long metric(double vx, double vy) {
        long metric = 0;
        for (int f : accumulator(vx, vy)) {
            metric += (long) f * f;
        }
        return metric;
    }

    private void ground(int left, int top) {
        graphics.setColor(GROUND);
        graphics.fillRect(left, top, width, height);
    }

    private void projection(int left, int top, double vx, double vy) {
        ground(left, top);
        int[] cells = accumulator(vx, vy);
        int columns = recording.sensor().width();
        for (int i = 0; i < cells.length; i++) {
            if (cells[i] != 0) {
                double share = 0.25 + 0.75 * Math.min(1, (double) Math.abs(cells[i]) / FULL_CELL);
                cell(left, top, i % columns, i / columns, mixed(cells[i] > 0 ? ON : OFF, share));
            }
        }
    }

    private void cell(int left, int top, int x, int y, Color colour) {
        graphics.setColor(colour);
        graphics.fillRect(left + SCALE * x, top + SCALE * y, SCALE, SCALE);
    }

    /** Mixes a share of a colour with the background of the panels. */
    private static Color mixed(int rgb, double share) {
        return new Color(
            (int) Math.round((rgb >> 16 & 0xFF) * share + GROUND.getRed() * (1 - share)),
            (int) Math.round((rgb >> 8 & 0xFF) * share + GROUND.getGreen() * (1 - share)),
            (int) Math.round((rgb & 0xFF) * share + GROUND.getBlue() * (1 - share)));
    }

    private void metrics(int left, int top, List<MetricMap.Maximum> maxima) {
        int side = height - 40;
        int x = left + 52;
        AffineTransform before = graphics.getTransform();
        graphics.drawImage(Charts.cells(map), x, top, side, side, null);
        graphics.setColor(SOFT);
        graphics.drawRect(x, top, side, side);
        graphics.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 12));
        for (int pxPerS : new int[] {-400, -150, -50, 0, 50, 150, 400}) {
            int at = (int) Math.round(MetricMap.place(pxPerS) * side);
            String label = Integer.toString(pxPerS);
            int labelWidth = graphics.getFontMetrics().stringWidth(label);
            graphics.drawLine(x + at, top + side, x + at, top + side + 4);
            graphics.drawString(label, x + at - labelWidth / 2, top + side + 17);
            graphics.drawLine(x - 4, top + at, x, top + at);
            graphics.drawString(label, x - 7 - labelWidth, top + at + 4);
        }
        graphics.drawString("vx, px/s", x + side / 2 - 22, top + side + 34);
        graphics.rotate(-Math.PI / 2);
        graphics.drawString("vy, px/s", -top - side / 2 - 22, left + 12);
        graphics.setTransform(before);
        graphics.setStroke(new BasicStroke(2));
        for (MetricMap.Maximum maximum : maxima) {
            int atX = x + (int) Math.round(cell(maximum.vxPxPerS()) * side);
            int atY = top + (int) Math.round(cell(maximum.vyPxPerS()) * side);
            graphics.setColor(new Color(ON));
            graphics.drawOval(atX - 14, atY - 14, 28, 28);
            label(velocity(maximum.vxPxPerS(), maximum.vyPxPerS()), atX, atY + 34, Color.WHITE);
        }
    }

    /** Writes a centred text on a background of its own. */
    private void label(String text, int x, int y, Color ground) {
        Color ink = graphics.getColor();
        graphics.setFont(new Font(Font.SANS_SERIF, Font.BOLD, 13));
        int textWidth = graphics.getFontMetrics().stringWidth(text);
        graphics.setColor(ground);
        graphics.fillRoundRect(x - textWidth / 2 - 4, y - 14, textWidth + 8, 19, 6, 6);
        graphics.setColor(ink);
        graphics.drawString(text, x - textWidth / 2, y);
    }

    /** The middle of a projection's cell on the map, from 0 to 1; the first and last cells of the map are whole. */
    private double cell(double pxPerS) {
        return (MetricMap.place(pxPerS) * (map.n() - 1) + 0.5) / map.n();
    }

    private void trackPlanes(int left, int top) {
        ground(left, top);
        Sofas sofas = new Sofas(recording.sensor(), SofasParameters.defaults());
        EventBatch batch = new EventBatch(1);
        FlowOutput flow = new FlowOutput(1);
        int until = 0;
        while (until < recording.size() && recording.timeUs[until] < untilUs) {
            until++;
        }
        int[] segment = new int[until];
        for (int i = 0; i < until; i++) {
            batch.clear();
            batch.add(recording.timeUs[i], recording.x[i], recording.y[i], recording.polarity[i]);
            sofas.process(batch, flow);
            segment[i] = flow.segment[0];
        }
        List<Segment> segments = sofas.segments();
        for (int k = 0; k < segments.size(); k++) {
            Color light = mixed(colour(k), 0.35);
            sofas.contour(segments.get(k).id(), (x, y) -> cell(left, top, x, y, light));
        }
        for (int i = 0; i < until; i++) {
            for (int k = 0; k < segments.size(); k++) {
                if (segment[i] == segments.get(k).id() && recording.timeUs[i] >= untilUs - EXPOSURE_US) {
                    cell(left, top, recording.x[i], recording.y[i], new Color(colour(k)));
                }
            }
        }
        for (int k = 0; k < segments.size(); k++) {
            arrow(left, top, segments.get(k), new Color(colour(k)));
        }
    }

    private static int colour(int place) {
        return Theme.LIGHT.segmentColour(place);
    }

    /** Draws the travel of half a second as an arrow from the middle of the structure. */
    private void arrow(int left, int top, Segment segment, Color colour) {
        double x = left + SCALE * (segment.minX() + segment.maxX()) / 2.0;
        double y = top + SCALE * (segment.minY() + segment.maxY()) / 2.0;
        double dx = SCALE * segment.vxPxPerS() / 2;
        double dy = SCALE * segment.vyPxPerS() / 2;
        double length = Math.hypot(dx, dy);
        graphics.setColor(colour);
        graphics.setStroke(new BasicStroke(3));
        graphics.draw(new Line2D.Double(x, y, x + dx, y + dy));
        Path2D head = new Path2D.Double();
        head.moveTo(x + dx + 12 * dx / length, y + dy + 12 * dy / length);
        head.lineTo(x + dx - 6 * dy / length, y + dy + 6 * dx / length);
        head.lineTo(x + dx + 6 * dy / length, y + dy - 6 * dx / length);
        head.closePath();
        graphics.fill(head);
        label(velocity(segment.vxPxPerS(), segment.vyPxPerS()), (int) x, top + SCALE * segment.minY() - 12, GROUND);
    }
}
