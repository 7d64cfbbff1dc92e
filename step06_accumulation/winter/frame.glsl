// What all shaders of the winter know of the frame: where it is seen from, and in what light. A uniform block
// that FrameBlock fills; GLSL and C++, like common/snow.glsl. All colours are linear. Light is measured by what
// it makes of a white surface that faces it: 1 is white paper in a bright room, snow in the sun is brighter.

struct Frame {
    mat4 view;           // world to eye space
    mat4 projection;     // eye to clip space
    mat4 view_before;    // the view of the frame before
    mat4 to_shadow_map;  // world space to the clip space in which the shadow map was drawn
    vec3 eye;            // m, world space
    float shutter;       // s since the frame before
    ivec2 window_size;   // pixels
    float field_depth;   // m of snow on open ground
    float extinction;    // fraction of the light that a metre of air takes away, 1/m
    vec3 to_sun;         // where the sun stands, or the moon by night: length 1, world space
    float lamp_is_on;    // 0 to 1
    vec3 sun;            // light of the sun, or the moon
    float lamp_radius;   // m
    vec3 zenith;         // colour of the sky overhead
    float exposure;
    vec3 horizon;        // and where it meets the ground: the colour of the air, too
    float bloom;         // fraction of the light that is spread
    vec3 twilight;       // what is added to that where the sun sets
    float fine_enough;   // m, length of a triangle's edge that need not be divided
    vec3 sky;            // light of the whole sky on a surface that faces up
    float wetness;       // of what lies open to the sky, 0 to 1
    vec3 ground;         // light from below on a surface that faces down
    float unused;        // fills the row of four, as the other does
    vec3 lamp;           // light of the lamp at a distance of 1 m
    float unused_too;
    vec3 lamp_position;  // m
    int colours;         // of flakes: 0 their own; else by speed, age or emitter
};

#ifndef __cplusplus
#include "common/bindings.glsl"

layout(std140, binding = FRAME_BLOCK) uniform FrameBlock
{
    Frame frame;
};
#endif
