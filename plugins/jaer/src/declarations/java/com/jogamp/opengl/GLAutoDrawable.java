package com.jogamp.opengl;

/** Signatures of the class of that name in JOGL that the filter needs; never run, never shipped. */
public interface GLAutoDrawable {
    GL getGL();
}
