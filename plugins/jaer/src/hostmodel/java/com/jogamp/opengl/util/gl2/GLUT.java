package com.jogamp.opengl.util.gl2;

import java.util.ArrayList;
import java.util.List;

/** As much of the class of that name in JOGL as the tests of the filter need. */
public class GLUT {
    public static final int BITMAP_HELVETICA_12 = 7;

    /** What was drawn. */
    public static final List<String> DRAWN = new ArrayList<>();

    public int glutBitmapLength(int font, String string) {
        return 6 * string.length();
    }

    public void glutBitmapString(int font, String string) {
        DRAWN.add(string);
    }
}
