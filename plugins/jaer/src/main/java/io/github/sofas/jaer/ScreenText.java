package io.github.sofas.jaer;

import com.jogamp.opengl.util.awt.TextRenderer;
import java.awt.Font;
import java.util.ArrayList;
import java.util.List;

/** Draws lines of text in screen pixels, white with a dark outline, so that they are legible on any picture. */
final class ScreenText {
    /** Extent of a line's background below and above the base line, as a share of the letters' height. */
    private static final float DESCENT = 0.25f;
    private static final float ASCENT = 1.05f;

    /** One line of text, and the box that holds it. */
    record Line(String text, Box box) {
    }

    private final List<Line> lines = new ArrayList<>();
    private TextRenderer renderer;
    private int size;

    /** Begins a picture, with letters of the given height in screen pixels. */
    void begin(int letters) {
        lines.clear();
        if (letters != size) {
            if (renderer != null) {
                renderer.dispose();
            }
            renderer = new TextRenderer(new Font(Font.SANS_SERIF, Font.PLAIN, letters), true, true);
            // otherwise some drivers draw nothing; jAER does the same
            renderer.setUseVertexArrays(false);
            size = letters;
        }
    }

    float width(String text) {
        // a little background on both sides
        return (float) renderer.getBounds(text).getWidth() + 4;
    }

    float height() {
        return (DESCENT + ASCENT) * size;
    }

    void add(String text, Box box) {
        lines.add(new Line(text, box));
    }

    List<Line> lines() {
        return lines;
    }

    /** Draws all lines at once, because changes of GL's state cost more than letters. */
    void draw(View view) {
        if (lines.isEmpty()) {
            return;
        }
        renderer.beginRendering(view.width(), view.height(), true);
        renderer.setColor(0, 0, 0, 0.8f);
        for (Line line : lines) {
            for (int corner = 0; corner < 4; corner++) {
                write(line, (corner & 1) * 2 - 1, (corner & 2) - 1);
            }
        }
        renderer.setColor(1, 1, 1, 1);
        for (Line line : lines) {
            write(line, 0, 0);
        }
        renderer.endRendering();
    }

    private void write(Line line, int right, int up) {
        renderer.draw(line.text(), Math.round(line.box().left()) + 2 + right,
            Math.round(line.box().bottom() + DESCENT * size) + up);
    }
}
