package io.github.sofas.jaer;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2;
import io.github.sofas.flow.Segment;
import java.awt.Color;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Draws the state of the engine after a packet over jAER's picture. Events, contours and arrows are drawn in chip
 * pixels; labels, legend and metrics in screen pixels. Both have their origin at the lower left. The state of GL is
 * left as it was.
 */
final class FlowDrawing {
    /** Length of an arrow, in s: its head is where the structure will be after this time. */
    private static final float ARROW_S = 0.25f;
    /**
     * Least height of letters, in screen pixels per unit of jAER's font size. The height grows with the picture, within
     * limits, so that letters are always legible.
     */
    private static final float LEAST_LETTERS = 1.8f;
    private static final float MOST_LETTERS = 4;
    private static final float LETTERS_A_PIXEL = 0.8f;
    /**
     * Turn and growth are sure if they move the outline with at least this share of the speed, and have moved it by at
     * least {@value #SURE_PX} px so far.
     */
    private static final double SURE_SHARE = 0.05;
    private static final double SURE_PX = 3;

    private final ScreenText text = new ScreenText();

    /** What the colour of an event shows. */
    public enum Colouring {
        /** The event's segment. */
        SEGMENT,
        /** The direction of the event's velocity, as on the colour wheel. */
        FLOW,
        /** Nothing: events are not drawn. */
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

    /**
     * Draws a picture.
     *
     * @param behind number of packets that the engine has not labelled yet
     */
    void draw(GL2 gl, Snapshot now, ShownEvents events, int behind, DrawingProperties shown) {
        gl.glPushAttrib(GL2.GL_CURRENT_BIT | GL2.GL_ENABLE_BIT | GL2.GL_LINE_BIT | GL.GL_COLOR_BUFFER_BIT);
        gl.glPushMatrix();
        try {
            gl.glEnable(GL.GL_BLEND);
            gl.glBlendFunc(GL.GL_SRC_ALPHA, GL.GL_ONE_MINUS_SRC_ALPHA);
            View view = View.of(gl);
            text.begin(Math.round(shown.getFontSize() * Math.max(LEAST_LETTERS,
                Math.min(MOST_LETTERS, LETTERS_A_PIXEL * view.pixel()))));
            drawEvents(gl, events, now.sensor().height(), shown.getEventColours());
            drawContours(gl, now, shown);
            if (shown.isSegmentVelocityShown()) {
                drawArrows(gl, now, shown);
            }
            gl.glTranslatef(-view.offsetX() / view.scaleX(), -view.offsetY() / view.scaleY(), 0);
            gl.glScalef(1 / view.scaleX(), 1 / view.scaleY(), 1);
            drawInScreenPixels(gl, view, now, events, behind, shown);
            text.draw(view);
        } finally {
            gl.glPopMatrix();
            gl.glPopAttrib();
        }
    }

    /** Draws events as squares: points are round, or leave gaps if a chip pixel is no whole number of screen pixels. */
    private static void drawEvents(GL2 gl, ShownEvents events, int height, Colouring colouring) {
        if (colouring == Colouring.NONE) {
            return;
        }
        gl.glBegin(GL2.GL_QUADS);
        int coloured = 0;
        for (int i = 0; i < events.size(); i++) {
            int segment = events.segment(i);
            if (segment != 0) {
                if (colouring == Colouring.FLOW) {
                    Colours.set(gl, Colours.of(events.vxPxPerS(i), -events.vyPxPerS(i)), 0.8f);
                } else if (segment != coloured) {
                    coloured = segment;
                    Colours.set(gl, Colours.of(coloured), 0.8f);
                }
                square(gl, events.x(i), height - 1 - events.y(i));
            }
        }
        gl.glEnd();
    }

    private static void square(GL2 gl, int x, int y) {
        gl.glVertex2f(x, y);
        gl.glVertex2f(x + 1, y);
        gl.glVertex2f(x + 1, y + 1);
        gl.glVertex2f(x, y + 1);
    }

    private static Color colourOf(Segment segment, DrawingProperties shown) {
        return shown.getEventColours() == Colouring.FLOW ? Colours.of(segment.vxPxPerS(), -segment.vyPxPerS())
            : Colours.of(segment.id());
    }

    private static void drawContours(GL2 gl, Snapshot now, DrawingProperties shown) {
        if (!shown.isContoursShown()) {
            return;
        }
        gl.glBegin(GL2.GL_QUADS);
        for (int i = 0; i < now.contours().size(); i++) {
            Colours.set(gl, colourOf(now.segments().get(i), shown), 0.45f);
            short[] cells = now.contours().get(i);
            for (int k = 0; k < cells.length; k += 2) {
                square(gl, cells[k], now.sensor().height() - 1 - cells[k + 1]);
            }
        }
        gl.glEnd();
    }

    private static void drawArrows(GL2 gl, Snapshot now, DrawingProperties shown) {
        gl.glLineWidth(2.5f);
        gl.glBegin(GL.GL_LINES);
        for (Segment segment : now.segments()) {
            Colours.set(gl, colourOf(segment, shown), 1);
            arrow(gl, (segment.minX() + segment.maxX() + 1) / 2f,
                now.sensor().height() - (segment.minY() + segment.maxY() + 1) / 2f,
                segment.vxPxPerS() * ARROW_S, -segment.vyPxPerS() * ARROW_S);
        }
        gl.glEnd();
    }

    private static void arrow(GL2 gl, float x, float y, float dx, float dy) {
        float headX = x + dx;
        float headY = y + dy;
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
    }

    private void drawInScreenPixels(GL2 gl, View view, Snapshot now, ShownEvents events, int behind,
                                    DrawingProperties shown) {
        Box sensor = view.onScreen(0, 0, now.sensor().width(), now.sensor().height());
        LabelLayout layout = new LabelLayout(view.width(), view.height());
        List<Box> leaders = new ArrayList<>();
        if (shown.isLegendShown()) {
            addLegend(legend(now, events, behind, shown), sensor, view, layout);
        }
        if (shown.isMetricShown() && now.metrics() != null) {
            Box inset = MetricInset.place(view, sensor, text.height());
            layout.take(inset);
            MetricInset.draw(gl, now.metrics(), inset);
            addTitle(MetricInset.title(now), inset, view, layout);
        }
        if (shown.isSegmentLabelsShown()) {
            addLabels(now, view, layout, leaders);
        }
        gl.glColor4f(0, 0, 0, 0.5f);
        gl.glBegin(GL2.GL_QUADS);
        for (ScreenText.Line line : text.lines()) {
            Box box = line.box();
            gl.glVertex2f(box.left(), box.bottom());
            gl.glVertex2f(box.right(), box.bottom());
            gl.glVertex2f(box.right(), box.top());
            gl.glVertex2f(box.left(), box.top());
        }
        gl.glEnd();
        drawLeaders(gl, leaders);
    }

    /** Draws lines from labels that lie apart to the structures that they name. */
    private static void drawLeaders(GL2 gl, List<Box> leaders) {
        gl.glColor4f(1, 1, 1, 0.6f);
        gl.glLineWidth(1);
        gl.glBegin(GL.GL_LINES);
        for (Box leader : leaders) {
            gl.glVertex2f(leader.left(), leader.bottom());
            gl.glVertex2f(leader.right(), leader.top());
        }
        gl.glEnd();
    }

    /** Places the labels of old structures first, so that they keep their places when new structures appear. */
    private void addLabels(Snapshot now, View view, LabelLayout layout, List<Box> leaders) {
        int height = now.sensor().height();
        for (Segment segment : now.segments()) {
            String label = label(segment);
            Box named = view.onScreen(segment.minX(), height - 1 - segment.maxY(), segment.maxX() + 1,
                height - segment.minY());
            Box box = layout.place(named, text.width(label), text.height());
            if (box != null) {
                text.add(label, box);
                float far = LabelLayout.GAP + 1;
                if (!Box.of(named.left() - far, named.bottom() - far, named.width() + 2 * far,
                        named.height() + 2 * far).overlaps(box)) {
                    leaders.add(new Box((box.left() + box.right()) / 2, (box.bottom() + box.top()) / 2,
                        (named.left() + named.right()) / 2, (named.bottom() + named.top()) / 2));
                }
            }
        }
    }

    /** Whether a turn or growth is more than an error of the velocity would look like. */
    private static boolean isSure(float perS, Segment segment) {
        double radius = Math.hypot(segment.maxX() + 1 - segment.minX(), segment.maxY() + 1 - segment.minY()) / 2;
        double pxPerS = Math.abs(perS) * radius;
        return pxPerS >= SURE_SHARE * Math.hypot(segment.vxPxPerS(), segment.vyPxPerS())
            && pxPerS * ageS(segment) >= SURE_PX;
    }

    private static double ageS(Segment segment) {
        return (segment.lastTimeUs() - segment.firstTimeUs()) * 1e-6;
    }

    /** Id, velocity and age of a segment; also turn and growth if they are sure. */
    static String label(Segment segment) {
        // rounded here, because a format would print -0
        StringBuilder label = new StringBuilder(String.format(Locale.ROOT, "%d: (%d, %d) px/s, %.1f s", segment.id(),
            Math.round(segment.vxPxPerS()), Math.round(-segment.vyPxPerS()),
            ageS(segment)));
        float turn = segment.turnRadPerS();
        if (isSure(turn, segment)) {
            label.append(String.format(Locale.ROOT, ", turns %s %.1f rad/s", turn > 0 ? "right" : "left",
                Math.abs(turn)));
        }
        float growth = segment.growthPerS();
        if (isSure(growth, segment)) {
            label.append(String.format(Locale.ROOT, ", %s %.2f/s", growth > 0 ? "grows" : "shrinks",
                Math.abs(growth)));
        }
        return label.toString();
    }

    /** Describes what the picture shows, in parts that may each begin a line. */
    private static List<String> legend(Snapshot now, ShownEvents events, int behind, DrawingProperties shown) {
        List<String> parts = new ArrayList<>();
        int segments = now.segments().size();
        parts.add(String.format(Locale.ROOT, "SOFAS: %d %s", segments, segments == 1 ? "segment" : "segments"));
        parts.add(String.format(Locale.ROOT, "%.0f %% of %,d events with flow",
            100.0 * events.withFlow() / Math.max(1, events.size()), events.size()));
        parts.add(switch (shown.getEventColours()) {
            case SEGMENT -> "a colour a segment";
            case FLOW -> "colour: direction of flow";
            case NONE -> "events not coloured";
        });
        if (shown.isSegmentVelocityShown()) {
            parts.add(String.format(Locale.ROOT, "arrows %.2f s long", ARROW_S));
        }
        if (behind > 0) {
            parts.add(behind == 1 ? "1 packet behind" : behind + " packets behind");
        }
        return parts;
    }

    /** Places the legend in the sensor's upper left corner, in as many lines as the legend needs. */
    private void addLegend(List<String> parts, Box sensor, View view, LabelLayout layout) {
        float left = Math.max(0, sensor.left() + 2);
        float top = Math.min(view.height(), sensor.top() - 2);
        String line = "";
        for (String part : parts) {
            String longer = line.isEmpty() ? part : line + "; " + part;
            if (!line.isEmpty() && left + text.width(longer) > view.width()) {
                top = addLine(line, left, top, layout);
                line = part;
            } else {
                line = longer;
            }
        }
        addLine(line, left, top, layout);
    }

    private float addLine(String line, float left, float top, LabelLayout layout) {
        Box box = Box.of(left, top - text.height(), text.width(line), text.height());
        text.add(line, box);
        layout.take(box);
        return box.bottom();
    }

    private void addTitle(String title, Box inset, View view, LabelLayout layout) {
        float left = Math.max(0, Math.min(inset.left(), view.width() - text.width(title)));
        Box box = Box.of(left, inset.top(), text.width(title), text.height());
        text.add(title, box);
        layout.take(box);
    }
}
