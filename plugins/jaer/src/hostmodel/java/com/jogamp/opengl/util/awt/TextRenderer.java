package com.jogamp.opengl.util.awt;

import java.awt.Font;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;

/** As much of the class of that name in JOGL as the tests of the filter need. */
public class TextRenderer {
    /** What was drawn in white, with its place. */
    public static final List<String> DRAWN = new ArrayList<>();
    /** Of the font used last. */
    public static int letters;

    private final Font font;
    private boolean white;

    public TextRenderer(Font font, boolean antialiased, boolean useFractionalMetrics) {
        this.font = font;
        letters = font.getSize();
    }

    public void setUseVertexArrays(boolean useVertexArrays) {
    }

    /** Letters as wide as half their height. */
    public Rectangle2D getBounds(String str) {
        return new Rectangle2D.Float(0, 0, str.length() * font.getSize() / 2f, font.getSize());
    }

    public void beginRendering(int width, int height, boolean disableDepthTest) {
    }

    public void setColor(float r, float g, float b, float a) {
        white = r == 1;
    }

    public void draw(String str, int x, int y) {
        if (white) {
            DRAWN.add(str);
        }
    }

    public void endRendering() {
    }

    public void dispose() {
    }
}
