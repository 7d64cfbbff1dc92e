// A surface of the scene, the whiter the deeper the snow on it.

#include "step05_collision/picture.glsl"
#include "step05_collision/shading.glsl"

float depth_at(vec3 point);  // m, of the snow there

in vec3 bare_position;
in vec3 world_position;
in vec3 world_normal;
in vec3 base_colour;

out vec4 colour;

void main()
{
    const vec3 snow_colour = vec3(0.90, 0.93, 0.97);
    const float least_upward = 0.1;  // normal.y of a surface on which snow can lie
    vec3 normal = normalize(gl_FrontFacing ? world_normal : -world_normal);  // towards the viewer
    float depth = normal.y > least_upward ? depth_at(bare_position) : 0.0;
    vec3 surface = mix(with_picture(base_colour), snow_colour, smoothstep(0.0, 0.02, depth));
    colour = vec4(lit(surface, normal, world_position), 1.0);
}
