package com.jogamp.opengl.util.awt;

import java.awt.Font;
import java.awt.geom.Rectangle2D;

/** Signatures of the class of that name in JOGL that the filter needs; never run, never shipped. */
public class TextRenderer {
    public TextRenderer(Font font, boolean antialiased, boolean useFractionalMetrics) {
        throw new UnsupportedOperationException();
    }

    public void setUseVertexArrays(boolean useVertexArrays) {
        throw new UnsupportedOperationException();
    }

    public Rectangle2D getBounds(String str) {
        throw new UnsupportedOperationException();
    }

    public void beginRendering(int width, int height, boolean disableDepthTest) {
        throw new UnsupportedOperationException();
    }

    public void setColor(float r, float g, float b, float a) {
        throw new UnsupportedOperationException();
    }

    public void draw(String str, int x, int y) {
        throw new UnsupportedOperationException();
    }

    public void endRendering() {
        throw new UnsupportedOperationException();
    }

    public void dispose() {
        throw new UnsupportedOperationException();
    }
}
