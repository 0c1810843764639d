package io.github.sofas.jaer;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2;
import com.jogamp.opengl.util.gl2.GLUT;
import io.github.sofas.event.EventBatch;
import io.github.sofas.event.SensorSize;
import io.github.sofas.flow.FlowOutput;
import io.github.sofas.flow.MetricArray;
import io.github.sofas.flow.Segment;
import io.github.sofas.flow.Sofas;
import io.github.sofas.flow.SofasParameters.Preset;
import java.awt.Color;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Draws what the engine knows over jAER's picture, in chip pixels with the origin lower left. Leaves the state of GL as
 * it was.
 */
final class FlowDrawing {
    /** Length of an arrow: where its structure will be after this time. */
    private static final float ARROW_S = 0.25f;
    /** Side of the inset as a share of the shorter side of the sensor. */
    private static final float INSET = 0.3f;
    /** Metric an event of white in the inset, at least: so that chance stays dark. */
    private static final float WHITE = 2;
    /** Steps of a sector's arc. */
    private static final int ARC = 4;
    private static final int FONT = GLUT.BITMAP_HELVETICA_12;
    /** Height of a line of text in screen pixels, and how far letters reach below it. */
    private static final float LINE = 13;
    private static final float BELOW = 3;
    private static final float GOLDEN = 0.618034f;

    private final GLUT glut = new GLUT();
    private final List<Label> labels = new ArrayList<>();

    /** A line of text; left end, base line and width in chip pixels. */
    private record Label(String text, float left, float bottom, float width) {
    }

    /** What events are coloured by. */
    public enum Colouring {
        /** Their segment. */
        SEGMENT,
        /** Direction of their velocity, as on the colour wheel. */
        FLOW,
        /** They are not drawn. */
        NONE;

        static Colouring of(String name) {
            for (Colouring colouring : values()) {
                if (colouring.name().equals(name)) {
                    return colouring;
                }
            }
            return SEGMENT;
        }
    }

    void draw(GL2 gl, Sofas sofas, PacketAdapter packet, SofasFlow shown) {
        gl.glPushAttrib(GL2.GL_CURRENT_BIT | GL2.GL_ENABLE_BIT | GL2.GL_LINE_BIT | GL2.GL_POINT_BIT
            | GL.GL_COLOR_BUFFER_BIT);
        gl.glPushMatrix();
        try {
            gl.glEnable(GL.GL_BLEND);
            gl.glBlendFunc(GL.GL_SRC_ALPHA, GL.GL_ONE_MINUS_SRC_ALPHA);
            SensorSize sensor = sofas.sensor();
            List<Segment> segments = sofas.segments();
            float pixel = pixelSize(gl);
            labels.clear();
            if (shown.getEventColours() != Colouring.NONE) {
                drawEvents(gl, packet, sensor, shown.getEventColours(), pixel);
            }
            for (Segment segment : segments) {
                drawSegment(gl, sofas, segment, shown, pixel);
            }
            if (shown.isMetricShown()) {
                drawMetric(gl, sofas.metricArray(), sensor);
            }
            if (shown.isLegendShown()) {
                addLegend(packet, segments.size(), shown, sensor, pixel);
            }
            drawLabels(gl, pixel);
        } finally {
            gl.glPopMatrix();
            gl.glPopAttrib();
        }
    }

    /** Screen pixels a chip pixel, in a picture with borders and zoom. */
    private static float pixelSize(GL2 gl) {
        int[] viewport = new int[4];
        gl.glGetIntegerv(GL.GL_VIEWPORT, viewport, 0);
        float[] projection = new float[16];
        gl.glGetFloatv(GL2.GL_PROJECTION_MATRIX, projection, 0);
        // the view is 2 wide and 2 high; the matrix is in columns
        return Math.max(1, Math.min(Math.abs(projection[0]) * viewport[2], Math.abs(projection[5]) * viewport[3]) / 2);
    }

    private static void drawEvents(GL2 gl, PacketAdapter packet, SensorSize sensor, Colouring colouring, float pixel) {
        EventBatch batch = packet.batch();
        FlowOutput flow = packet.output();
        gl.glPointSize(pixel);
        gl.glBegin(GL.GL_POINTS);
        int coloured = 0;
        for (int i = 0; i < batch.size(); i++) {
            if (flow.segment[i] != 0) {
                if (colouring == Colouring.FLOW) {
                    colour(gl, colourOf(flow.vxPxPerS[i], -flow.vyPxPerS[i]), 0.8f);
                } else if (flow.segment[i] != coloured) {
                    coloured = flow.segment[i];
                    colour(gl, colourOf(coloured), 0.8f);
                }
                gl.glVertex2f(batch.x[i] + 0.5f, sensor.height() - 1 - batch.y[i] + 0.5f);
            }
        }
        gl.glEnd();
    }

    private void drawSegment(GL2 gl, Sofas sofas, Segment segment, SofasFlow shown, float pixel) {
        int height = sofas.sensor().height();
        Color colour = shown.getEventColours() == Colouring.FLOW ? colourOf(segment.vxPxPerS(), -segment.vyPxPerS())
            : colourOf(segment.id());
        float centreX = (segment.minX() + segment.maxX() + 1) / 2f;
        float centreY = height - (segment.minY() + segment.maxY() + 1) / 2f;
        if (shown.isContoursShown()) {
            colour(gl, colour, 0.45f);
            gl.glPointSize(pixel);
            gl.glBegin(GL.GL_POINTS);
            sofas.contour(segment.id(), (x, y) -> gl.glVertex2f(x + 0.5f, height - 1 - y + 0.5f));
            gl.glEnd();
        }
        if (shown.isSegmentVelocityShown()) {
            colour(gl, colour, 1);
            arrow(gl, centreX, centreY, segment.vxPxPerS() * ARROW_S, -segment.vyPxPerS() * ARROW_S);
        }
        if (shown.isSegmentLabelsShown()) {
            // rounded here, since a format would print -0
            String text = String.format(Locale.ROOT, "%d: (%d, %d) px/s, %.1f s", segment.id(),
                Math.round(segment.vxPxPerS()), Math.round(-segment.vyPxPerS()),
                (segment.lastTimeUs() - segment.firstTimeUs()) * 1e-6);
            addLabel(sofas.sensor(), pixel, segment.minX(), height - segment.minY() + 2, text);
        }
    }

    private static void arrow(GL2 gl, float x, float y, float dx, float dy) {
        float headX = x + dx;
        float headY = y + dy;
        gl.glLineWidth(2.5f);
        gl.glBegin(GL.GL_LINES);
        gl.glVertex2f(x, y);
        gl.glVertex2f(headX, headY);
        float length = (float) Math.hypot(dx, dy);
        if (length > 0) {
            float head = Math.min(6, 0.4f * length) / length;
            gl.glVertex2f(headX, headY);
            gl.glVertex2f(headX - head * (dx - 0.5f * dy), headY - head * (dy + 0.5f * dx));
            gl.glVertex2f(headX, headY);
            gl.glVertex2f(headX - head * (dx + 0.5f * dy), headY - head * (dy - 0.5f * dx));
        }
        gl.glEnd();
    }

    /** Text of one size whatever the window's, kept on the sensor. */
    private void addLabel(SensorSize sensor, float pixel, float x, float y, String text) {
        float width = glut.glutBitmapLength(FONT, text) / pixel;
        float left = Math.max(0, Math.min(x, sensor.width() - width));
        float bottom = Math.max(BELOW / pixel, Math.min(y, sensor.height() - LINE / pixel));
        labels.add(new Label(text, left, bottom, width));
    }

    /** All at once: letters are slow to draw, and each change of colour makes them slower. */
    private void drawLabels(GL2 gl, float pixel) {
        if (labels.isEmpty()) {
            return;
        }
        gl.glColor4f(0, 0, 0, 0.5f);
        gl.glBegin(GL2.GL_QUADS);
        for (Label label : labels) {
            quad(gl, label.left(), label.bottom() - BELOW / pixel, label.width(), LINE / pixel);
        }
        gl.glEnd();
        gl.glColor4f(1, 1, 1, 1);
        for (Label label : labels) {
            gl.glRasterPos2f(label.left(), label.bottom());
            glut.glutBitmapString(FONT, label.text());
        }
    }

    /** The metrics, from chance (dark) to the greatest (white), in the lower right corner. */
    private static void drawMetric(GL2 gl, MetricArray metrics, SensorSize sensor) {
        int n = metrics.n();
        float most = 0;
        for (int i = 0; i < n * n; i++) {
            most = Math.max(most, metrics.perEvent(i / n, i % n));
        }
        if (most <= 1) {
            return;
        }
        float white = Math.max(most, WHITE);
        float side = INSET * Math.min(sensor.width(), sensor.height());
        float left = sensor.width() - side - 2;
        float bottom = 2;
        gl.glColor4f(0, 0, 0, 0.5f);
        gl.glBegin(GL2.GL_QUADS);
        quad(gl, left - 1, bottom - 1, side + 2, side + 2);
        for (int row = 0; row < n; row++) {
            for (int column = 0; column < n; column++) {
                float bright = Math.max(0, metrics.perEvent(row, column) - 1) / (white - 1);
                gl.glColor4f(bright, bright, bright, 0.9f);
                if (metrics.preset() == Preset.PAPER) {
                    // rows are angles along y, positive down
                    quad(gl, left + column * side / n, bottom + (n - 1 - row) * side / n, side / n, side / n);
                } else {
                    sector(gl, left + side / 2, bottom + side / 2, side / 2, n, row, column);
                }
            }
        }
        gl.glEnd();
    }

    private static void quad(GL2 gl, float left, float bottom, float width, float height) {
        gl.glVertex2f(left, bottom);
        gl.glVertex2f(left + width, bottom);
        gl.glVertex2f(left + width, bottom + height);
        gl.glVertex2f(left, bottom + height);
    }

    /** A ring's part around a direction; the innermost ring begins a step off the centre. */
    private static void sector(GL2 gl, float x, float y, float radius, int n, int ring, int direction) {
        float inner = radius * (ring + 1) / (n + 1);
        float outer = radius * (ring + 2) / (n + 1);
        for (int k = 0; k < ARC; k++) {
            double from = 2 * Math.PI * (direction + 0.5 * (ring & 1) - 0.5 + (double) k / ARC) / n;
            double to = from + 2 * Math.PI / n / ARC;
            // angles of the engine turn towards y down
            gl.glVertex2f(x + inner * (float) Math.cos(from), y - inner * (float) Math.sin(from));
            gl.glVertex2f(x + outer * (float) Math.cos(from), y - outer * (float) Math.sin(from));
            gl.glVertex2f(x + outer * (float) Math.cos(to), y - outer * (float) Math.sin(to));
            gl.glVertex2f(x + inner * (float) Math.cos(to), y - inner * (float) Math.sin(to));
        }
    }

    private void addLegend(PacketAdapter packet, int segments, SofasFlow shown, SensorSize sensor, float pixel) {
        int events = packet.batch().size();
        int with = 0;
        for (int i = 0; i < events; i++) {
            with += packet.output().segment[i] == 0 ? 0 : 1;
        }
        String colours = switch (shown.getEventColours()) {
            case SEGMENT -> "a colour a segment";
            case FLOW -> "colour: direction of flow";
            case NONE -> "events not coloured";
        };
        addLabel(sensor, pixel, 1, sensor.height() - LINE / pixel, String.format(Locale.ROOT,
            "SOFAS: %d segments, %.0f %% of %,d events with flow; %s; arrows %.2f s long", segments,
            100.0 * with / Math.max(1, events), events, colours, ARROW_S));
    }

    private static void colour(GL2 gl, Color colour, float alpha) {
        gl.glColor4f(colour.getRed() / 255f, colour.getGreen() / 255f, colour.getBlue() / 255f, alpha);
    }

    /** Successive ids lie far apart on the wheel of hues. */
    private static Color colourOf(int segment) {
        return Color.getHSBColor(segment * GOLDEN % 1, 0.75f, 1);
    }

    /** jAER's colour of a direction, y up. */
    private static Color colourOf(float vx, float vy) {
        return Color.getHSBColor((float) (Math.atan2(vy, vx) / (2 * Math.PI) + 0.5), 1, 1);
    }
}
