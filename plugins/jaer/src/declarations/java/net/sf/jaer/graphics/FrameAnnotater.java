package net.sf.jaer.graphics;

import com.jogamp.opengl.GLAutoDrawable;

/** Signatures of the class of that name in jAER that the filter needs; never run, never shipped. */
public interface FrameAnnotater {
    void annotate(GLAutoDrawable drawable);
}
