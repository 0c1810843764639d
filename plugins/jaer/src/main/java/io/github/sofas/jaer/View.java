package io.github.sofas.jaer;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2;

/**
 * Converts chip pixels to screen pixels: jAER's picture has borders, a zoom and any size. Both kinds of pixels have
 * their origin at the lower left.
 *
 * @param scaleX screen pixels per chip pixel, to the right
 * @param scaleY screen pixels per chip pixel, upwards
 * @param offsetX position of the chip's left edge, in screen pixels
 * @param offsetY position of the chip's lower edge, in screen pixels
 * @param width width of the picture, in screen pixels
 * @param height height of the picture, in screen pixels
 */
record View(float scaleX, float scaleY, float offsetX, float offsetY, int width, int height) {

    /** The view according to the present matrices of GL. */
    static View of(GL2 gl) {
        int[] viewport = new int[4];
        gl.glGetIntegerv(GL.GL_VIEWPORT, viewport, 0);
        float[] model = new float[16];
        gl.glGetFloatv(GL2.GL_MODELVIEW_MATRIX, model, 0);
        float[] projection = new float[16];
        gl.glGetFloatv(GL2.GL_PROJECTION_MATRIX, projection, 0);
        // matrices are stored by columns; the picture extends from -1 to 1 along both axes
        float halfWidth = viewport[2] / 2f;
        float halfHeight = viewport[3] / 2f;
        return new View(halfWidth * projection[0] * model[0], halfHeight * projection[5] * model[5],
            halfWidth * (projection[0] * model[12] + projection[12] + 1),
            halfHeight * (projection[5] * model[13] + projection[13] + 1), viewport[2], viewport[3]);
    }

    /** Screen pixels per chip pixel, along the axis with fewer. */
    float pixel() {
        return Math.min(Math.abs(scaleX), Math.abs(scaleY));
    }

    /** The place on the screen of a rectangle of chip pixels. */
    Box onScreen(float left, float bottom, float right, float top) {
        return new Box(offsetX + scaleX * left, offsetY + scaleY * bottom, offsetX + scaleX * right,
            offsetY + scaleY * top);
    }
}
