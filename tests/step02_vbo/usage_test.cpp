// What --hint makes of glBufferData's last argument.
#include "step02_vbo/usage.hpp"

#include <gtest/gtest.h>

TEST(Usage, IsNamedAsOpenGLNamesIt)
{
    EXPECT_EQ(usage("stream"), GLenum(GL_STREAM_DRAW));
    EXPECT_EQ(usage("dynamic"), GLenum(GL_DYNAMIC_DRAW));
    EXPECT_EQ(usage("static"), GLenum(GL_STATIC_DRAW));
}
