package io.github.sofas.jaer;

import com.jogamp.opengl.GL2;
import io.github.sofas.flow.MetricArray;
import io.github.sofas.flow.SofasParameters.Preset;
import java.util.Locale;

/** The metrics of the flow plane as a small picture: beside the sensor where there is room, else on it. */
final class MetricInset {
    /** Metric an event of white, at least: so that chance stays dark. */
    private static final float WHITE = 2;
    /** Steps of a sector's arc. */
    private static final int ARC = 4;
    private static final float MARGIN = 4;
    /** Side as a share of the shorter side of the sensor, and the least that is of use, in screen pixels. */
    private static final float SHARE = 0.3f;
    private static final float LEAST = 60;

    private MetricInset() {
    }

    /**
     * Where it lies: right of the sensor, left, below or above, where its title fits there, else in the sensor's lower
     * right corner.
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

    /** What it shows, and from what to what. */
    static String title(Snapshot now) {
        return now.parameters().preset() == Preset.PAPER
            ? String.format(Locale.ROOT, "search: angles along x, y; 45 deg = %.0f px/s",
                now.parameters().published().velocityScalePxPerS())
            : String.format(Locale.ROOT, "search: direction; %.0f to %.0f px/s outwards",
                now.parameters().search().slowestPxPerS(), now.parameters().search().fastestPxPerS());
    }

    /** Draws it, in screen pixels: what is chance can be seen through, the greatest metric is white. */
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
                    // rows are angles along y, positive down
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

    /** A ring's part around a direction; the innermost ring begins a step off the centre. */
    private static void sector(GL2 gl, Box box, int n, int ring, int direction) {
        float x = (box.left() + box.right()) / 2;
        float y = (box.bottom() + box.top()) / 2;
        float inner = box.width() / 2 * (ring + 1) / (n + 1);
        float outer = box.width() / 2 * (ring + 2) / (n + 1);
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
}
