// Where this picture is taken from: GLSL and C++, like common/snow.glsl.

struct CameraView {
    mat4 view;          // world to eye space
    mat4 projection;    // eye to clip space
    mat4 view_before;   // the view of the frame before
    vec3 eye;           // m, world space
    float shutter;      // s since the frame before
    ivec2 window_size;  // pixels
    float field_depth;  // m of snow on open ground
    float unused;       // fills the row of four
};

#ifndef __cplusplus
#include "common/bindings.glsl"

layout(std140, binding = CAMERA_BLOCK) uniform CameraBlock
{
    CameraView camera;
};
#endif
