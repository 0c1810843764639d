package net.sf.jaer.graphics;

import com.jogamp.opengl.GLAutoDrawable;

/** As much of the class of that name in jAER as the tests of the filter need. */
public interface FrameAnnotater {
    void annotate(GLAutoDrawable drawable);
}
