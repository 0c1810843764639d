package io.github.sofas.jaer;

import com.jogamp.opengl.GL;
import com.jogamp.opengl.GL2;

/**
 * Where chip pixels are on the screen: jAER's picture has borders, zoom and any size. Both with the origin lower left.
 *
 * @param scaleX screen pixels a chip pixel
 * @param scaleY the same upwards
 * @param offsetX where the chip's left edge is, in screen pixels
 * @param offsetY where its lower edge is
 * @param width of the picture in screen pixels
 * @param height of the picture in screen pixels
 */
record View(float scaleX, float scaleY, float offsetX, float offsetY, int width, int height) {

    /** As GL has it now. */
    static View of(GL2 gl) {
        int[] viewport = new int[4];
        gl.glGetIntegerv(GL.GL_VIEWPORT, viewport, 0);
        float[] model = new float[16];
        gl.glGetFloatv(GL2.GL_MODELVIEW_MATRIX, model, 0);
        float[] projection = new float[16];
        gl.glGetFloatv(GL2.GL_PROJECTION_MATRIX, projection, 0);
        // matrices are in columns, the picture goes from -1 to 1 both ways
        float halfWidth = viewport[2] / 2f;
        float halfHeight = viewport[3] / 2f;
        return new View(halfWidth * projection[0] * model[0], halfHeight * projection[5] * model[5],
            halfWidth * (projection[0] * model[12] + projection[12] + 1),
            halfHeight * (projection[5] * model[13] + projection[13] + 1), viewport[2], viewport[3]);
    }

    /** Screen pixels a chip pixel, the smaller of both. */
    float pixel() {
        return Math.min(Math.abs(scaleX), Math.abs(scaleY));
    }

    /** A rectangle of chip pixels on the screen. */
    Box onScreen(float left, float bottom, float right, float top) {
        return new Box(offsetX + scaleX * left, offsetY + scaleY * bottom, offsetX + scaleX * right,
            offsetY + scaleY * top);
    }
}
