#version 330 core
// Places a flake on the screen and makes its sprite as many pixels wide as the flake looks from here.

#include "common/snow.glsl"

layout(std140) uniform WeatherBlock { Weather weather; };
uniform mat4 view;
uniform mat4 projection;
uniform float window_height;  // pixels

layout(location = 0) in vec3 position;  // m

flat out uint index;  // of the flake: picks its crystal
out float coverage;   // of the sprite's pixels by the flake, 0 to 1

void main()
{
    index = uint(gl_VertexID);
    gl_Position = projection * view * vec4(position, 1.0);
    // projection[1][1] is 1 / tan(half the field of view), gl_Position.w the distance along the view.
    float pixels = window_height * 0.5 * projection[1][1] * diameter(index, weather) / gl_Position.w;
    // A sprite cannot be narrower than a pixel and still be seen steadily: a smaller flake covers only a
    // part of its pixel.
    gl_PointSize = max(pixels, 1.5);
    coverage = min(pixels * pixels / (1.5 * 1.5), 1.0);
}
