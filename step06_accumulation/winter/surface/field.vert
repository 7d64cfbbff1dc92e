#version 430 core
// A vertex of the field around the scene, on top of the snow that lies on open ground.

#include "step06_accumulation/winter/light/air.glsl"

layout(location = 0) in vec3 position;

out Place place;
out vec4 air;

void main()
{
    vec3 world_position = position + vec3(0.0, camera.field_depth, 0.0);
    place = place_of(world_position, vec3(0.0, 1.0, 0.0));
    air = air_before(world_position);
    gl_Position = camera.projection * camera.view * vec4(world_position, 1.0);
}
