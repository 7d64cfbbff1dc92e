// The ground of steps 1 to 4, a grid of squares 2 m wide at y = 0: a frame of reference.
#pragma once

#include <GL/glew.h>

#include <glm/gtc/type_ptr.hpp>

#include "common/window.hpp"

// Tells OpenGL's fixed functions where the camera is.
inline void load_matrices(const Window& window)
{
    glMatrixMode(GL_PROJECTION);
    glLoadMatrixf(glm::value_ptr(window.projection()));
    glMatrixMode(GL_MODELVIEW);
    glLoadMatrixf(glm::value_ptr(window.view()));
}

inline void draw_ground(const Window& window)
{
    if (GLEW_VERSION_2_0) glUseProgram(0);  // from step 3 on there are shaders, but not for this
    load_matrices(window);
    glColor3f(0.26f, 0.29f, 0.34f);
    glBegin(GL_LINES);
    for (int line = -8; line <= 8; line += 2) {  // m; the clouds are as wide
        glVertex3i(line, 0, -8);
        glVertex3i(line, 0, 8);
        glVertex3i(-8, 0, line);
        glVertex3i(8, 0, line);
    }
    glEnd();
    glColor3f(1.0f, 1.0f, 1.0f);  // the colour of the flakes
}
