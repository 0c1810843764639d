package com.jogamp.opengl;

/** As much of the class of that name in JOGL as the tests of the filter need. */
public interface GLAutoDrawable {
    GL getGL();
}
