package io.github.sofas.jaer;

import com.jogamp.opengl.GL2;
import io.github.sofas.flow.MetricArray;
import io.github.sofas.flow.SofasParameters.Preset;
import java.util.Locale;

/**
 * Draws the metrics of the flow plane as a small picture, the inset: beside the sensor if there is room, or else on the
 * sensor.
 */
final class MetricInset {
    /** Least metric per event that is drawn white, so that chance stays dark. */
    private static final float WHITE = 2;
    /** Number of straight steps that approximate the arc of a sector. */
    private static final int ARC = 4;
    private static final float MARGIN = 4;
    /** Side of the inset as a share of the sensor's shorter side; and the least useful side, in screen pixels. */
    private static final float SHARE = 0.3f;
    private static final float LEAST = 60;

    private MetricInset() {
    }

    /**
     * The place of the inset: right of the sensor, left, below or above, if there is room for it and for its title; or
     * else in the sensor's lower right corner.
     */
    static Box place(View view, Box sensor, float titleHeight) {
        float wanted = Math.max(LEAST, Math.round(SHARE * Math.min(sensor.width(), sensor.height())));
        float right = view.width() - sensor.right();
        float left = sensor.left();
        float below = sensor.bottom();
        float above = view.height() - sensor.top();
        float sideways = Math.max(right, left) - 2 * MARGIN;
        float upright = Math.max(below, above) - 2 * MARGIN - titleHeight;
        float side = Math.min(wanted, Math.max(sideways, upright));
        if (side < LEAST) {
            return Box.of(sensor.right() - MARGIN - wanted, sensor.bottom() + MARGIN, wanted, wanted);
        }
        if (sideways >= upright) {
            return Box.of(right >= left ? view.width() - MARGIN - side : MARGIN, sensor.bottom() + MARGIN, side, side);
        }
        return Box.of(sensor.right() - MARGIN - side, below >= above ? MARGIN : sensor.top() + MARGIN, side, side);
    }

    /** The title: what the inset shows, and its range. */
    static String title(Snapshot now) {
        return now.parameters().preset() == Preset.PAPER
            ? String.format(Locale.ROOT, "search: angles along x, y; 45 deg = %.0f px/s",
                now.parameters().published().velocityScalePxPerS())
            : String.format(Locale.ROOT, "search: direction; %.0f to %.0f px/s outwards",
                now.parameters().search().slowestPxPerS(), now.parameters().search().fastestPxPerS());
    }

    /** Draws the inset, in screen pixels: chance is translucent, the greatest metric is white. */
    static void draw(GL2 gl, MetricArray metrics, Box box) {
        int n = metrics.n();
        float white = WHITE;
        for (int i = 0; i < n * n; i++) {
            white = Math.max(white, metrics.perEvent(i / n, i % n));
        }
        gl.glColor4f(0, 0, 0, 0.35f);
        gl.glBegin(GL2.GL_QUADS);
        quad(gl, box.left(), box.bottom(), box.width(), box.height());
        float side = box.width() / n;
        for (int row = 0; row < n; row++) {
            for (int column = 0; column < n; column++) {
                float bright = Math.max(0, metrics.perEvent(row, column) - 1) / (white - 1);
                gl.glColor4f(bright, bright, bright, 0.25f + 0.6f * bright);
                if (metrics.preset() == Preset.PAPER) {
                    // rows are angles along y, which is positive downwards
                    quad(gl, box.left() + column * side, box.bottom() + (n - 1 - row) * side, side, side);
                } else {
                    sector(gl, box, n, row, column);
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

    /** Draws the part of a ring around one direction. The innermost ring begins one step off the centre. */
    private static void sector(GL2 gl, Box box, int n, int ring, int direction) {
        float x = (box.left() + box.right()) / 2;
        float y = (box.bottom() + box.top()) / 2;
        float inner = box.width() / 2 * (ring + 1) / (n + 1);
        float outer = box.width() / 2 * (ring + 2) / (n + 1);
        for (int k = 0; k < ARC; k++) {
            double from = 2 * Math.PI * (direction + 0.5 * (ring & 1) - 0.5 + (double) k / ARC) / n;
            double to = from + 2 * Math.PI / n / ARC;
            // the engine's angles turn from x towards y, which points down
            gl.glVertex2f(x + inner * (float) Math.cos(from), y - inner * (float) Math.sin(from));
            gl.glVertex2f(x + outer * (float) Math.cos(from), y - outer * (float) Math.sin(from));
            gl.glVertex2f(x + outer * (float) Math.cos(to), y - outer * (float) Math.sin(to));
            gl.glVertex2f(x + inner * (float) Math.cos(to), y - inner * (float) Math.sin(to));
        }
    }
}
