// The ground of steps 1 to 4, a grid of squares 2 m wide at y = 0. Snow alone gives the eye no
// frame of reference (Jorgensen's complaint): it cannot tell how fast flakes fall, nor how far off
// they are.
#pragma once

#include <GL/glew.h>

#include <glm/gtc/type_ptr.hpp>

#include "common/window.hpp"

inline void draw_ground(const Window& window)
{
    if (GLEW_VERSION_2_0) glUseProgram(0);  // from step 3 on there are shaders, but not for this
    glMatrixMode(GL_PROJECTION);
    glLoadMatrixf(glm::value_ptr(window.projection()));
    glMatrixMode(GL_MODELVIEW);
    glLoadMatrixf(glm::value_ptr(window.view()));
    glColor3f(0.26f, 0.29f, 0.34f);
    glBegin(GL_LINES);
    for (int at = -8; at <= 8; at += 2) {  // m; the clouds are as wide
        glVertex3i(at, 0, -8);
        glVertex3i(at, 0, 8);
        glVertex3i(-8, 0, at);
        glVertex3i(8, 0, at);
    }
    glEnd();
    glColor3f(1.0f, 1.0f, 1.0f);  // of the flakes
}
