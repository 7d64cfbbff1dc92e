#version 430 core
// A corner of an arrow that shows the wind at a place: as long as the air is fast, flat, and turned
// towards the eye. Where the arrow stands follows from its number.

#include "common/weather_block.glsl"
#include "step05_collision/voxels.glsl"
#include "step06_accumulation/winter/camera/camera.glsl"
#include "step06_accumulation/winter/wind/wind_field.glsl"

uniform uint tick;

out vec3 arrow_colour;

// The shaft as two triangles and the head as one: along the arrow, and across it, in widths.
const vec2 outline[9] = vec2[](vec2(-0.5, -0.3), vec2(0.2, -0.3), vec2(0.2, 0.3), vec2(-0.5, -0.3), vec2(0.2, 0.3),
                               vec2(-0.5, 0.3), vec2(0.15, -1.0), vec2(0.5, 0.0), vec2(0.15, 1.0));

void main()
{
    // Every other of the field's 32 cells along x and z, every third above the ground.
    ivec3 place = ivec3(gl_InstanceID % 16, gl_InstanceID / 256, gl_InstanceID / 16 % 16);
    float spacing = cell_size * float(resolution) / 16.0;
    vec3 middle = grid_origin + spacing * (vec3(place) * vec3(1.0, 1.5, 1.0) + vec3(0.5, 0.75, 0.5));
    vec3 air = wind_at(middle, tick) + vortices(middle, tick, weather);
    float speed = length(air) / max(length(weather.wind) + weather.swirl, 0.001);  // of the undisturbed air

    vec3 along = air / max(length(air), 0.001);
    vec3 across = cross(along, camera.eye - middle);
    across /= max(length(across), 0.001);  // an arrow that points at the eye has no width
    vec2 corner = outline[gl_VertexID];
    vec3 position = middle + 0.8 * spacing * min(speed, 1.5) * corner.x * along + 0.05 * spacing * corner.y * across;
    arrow_colour = mix(mix(vec3(0.1, 0.3, 0.9), vec3(0.9, 0.85, 0.3), smoothstep(0.0, 0.8, speed)),
                       vec3(0.9, 0.15, 0.1), smoothstep(0.8, 1.3, speed));
    bool hidden = speed < 0.02 || in_scene(ivec3((middle - grid_origin) / cell_size));
    gl_Position = hidden ? vec4(0.0) : camera.projection * camera.view * vec4(position, 1.0);
}
