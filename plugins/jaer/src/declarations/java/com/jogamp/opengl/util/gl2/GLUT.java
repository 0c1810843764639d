package com.jogamp.opengl.util.gl2;

/** Signatures of the class of that name in JOGL that the filter needs; never run, never shipped. */
public class GLUT {
    public static final int BITMAP_HELVETICA_12 = 7;

    public int glutBitmapLength(int font, String string) {
        throw new UnsupportedOperationException();
    }

    public void glutBitmapString(int font, String string) {
        throw new UnsupportedOperationException();
    }
}
