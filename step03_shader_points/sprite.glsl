// What a vertex shader has to do to draw a flake as a point sprite.

#include "common/weather_block.glsl"

uniform mat4 view;
uniform mat4 projection;
uniform float window_height;  // pixels

flat out uint index;  // of the flake: picks its crystal
out float coverage;   // opacity of the sprite as a whole, 0 to 1

// flake: its index. position: m. rest: how long it has lain, s; it fades while it melts.
void draw_sprite(uint flake, vec3 position, float rest)
{
    const float least_pixels = 2.0;  // a narrower sprite would flicker as it moves from pixel to pixel
    index = flake;
    vec4 seen = view * vec4(position, 1.0);
    gl_Position = projection * seen;
    // The sprite stands upright in its flake's depth, so a floor would cut off its lower half: draw it as
    // deep as the nearest point of the flake, which may not lie behind the eye.
    float nearer = min(diameter(index, weather), 0.5 * gl_Position.w);
    vec4 nearest = projection * (seen + vec4(0.0, 0.0, nearer, 0.0));
    gl_Position.z = nearest.z / nearest.w * gl_Position.w;
    // projection[1][1] is 1 / tan(half the field of view), gl_Position.w the distance along the view.
    float pixels = window_height * 0.5 * projection[1][1] * diameter(index, weather) / gl_Position.w;
    gl_PointSize = max(pixels, least_pixels);
    // A smaller flake covers only a fraction of its sprite.
    float fraction = min(pixels / least_pixels, 1.0);
    coverage = fraction * fraction * (1.0 - clamp(rest / max(weather.melt_time, weather.time_step), 0.0, 1.0));
}
