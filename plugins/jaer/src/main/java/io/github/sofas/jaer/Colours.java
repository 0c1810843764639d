package io.github.sofas.jaer;

import com.jogamp.opengl.GL2;
import java.awt.Color;

/** Colours of segments and of directions of flow. */
final class Colours {
    private static final float GOLDEN = 0.618034f;

    private Colours() {
    }

    /** The colour of a segment: successive ids lie far apart on the wheel of hues. */
    static Color of(int segment) {
        return Color.getHSBColor(segment * GOLDEN % 1, 0.75f, 1);
    }

    /** jAER's colour for the direction of a velocity, with y up. */
    static Color of(float vx, float vy) {
        return Color.getHSBColor((float) (Math.atan2(vy, vx) / (2 * Math.PI) + 0.5), 1, 1);
    }

    static void set(GL2 gl, Color colour, float alpha) {
        gl.glColor4f(colour.getRed() / 255f, colour.getGreen() / 255f, colour.getBlue() / 255f, alpha);
    }
}
