package com.jogamp.opengl;

/** Signatures of the class of that name in JOGL that the filter needs; never run, never shipped. */
public interface GL {
    int GL_LINES = 0x1;
    int GL_SRC_ALPHA = 0x302;
    int GL_ONE_MINUS_SRC_ALPHA = 0x303;
    int GL_VIEWPORT = 0xba2;
    int GL_BLEND = 0xbe2;
    int GL_COLOR_BUFFER_BIT = 0x4000;

    GL2 getGL2();

    void glBlendFunc(int sfactor, int dfactor);

    void glEnable(int cap);

    void glGetFloatv(int pname, float[] params, int offset);

    void glGetIntegerv(int pname, int[] params, int offset);

    void glLineWidth(float width);
}
