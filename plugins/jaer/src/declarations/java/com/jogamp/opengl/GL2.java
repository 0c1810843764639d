package com.jogamp.opengl;

/** Signatures of the class of that name in JOGL that the filter needs; never run, never shipped. */
public interface GL2 extends GL {
    int GL_CURRENT_BIT = 0x1;
    int GL_LINE_BIT = 0x4;
    int GL_QUADS = 0x7;
    int GL_MODELVIEW_MATRIX = 0xba6;
    int GL_PROJECTION_MATRIX = 0xba7;
    int GL_ENABLE_BIT = 0x2000;

    void glBegin(int mode);

    void glColor4f(float red, float green, float blue, float alpha);

    void glEnd();

    void glPopAttrib();

    void glPopMatrix();

    void glPushAttrib(int mask);

    void glPushMatrix();

    void glScalef(float x, float y, float z);

    void glTranslatef(float x, float y, float z);

    void glVertex2f(float x, float y);
}
