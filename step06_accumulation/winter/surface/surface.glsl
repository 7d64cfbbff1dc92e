// Lifts a point of the scene by the snow that lies on it, and hands it on to surface.frag.

#include "step06_accumulation/winter/camera/camera.glsl"
#include "step06_accumulation/winter/surface/smooth_depth.glsl"

invariant gl_Position;  // tessellated or not, along an edge that both kinds of triangles share

out vec3 base_position;   // m, of the scene without snow
out vec3 world_position;  // m, on top of the snow
out vec3 base_normal;     // of the scene without snow
out vec3 base_colour;
out vec2 picture_uv;
out float is_skirt;       // 1: the side of the snow, where the surface it lies on ends

void put_on_snow(vec3 position, vec3 normal, vec3 colour, vec2 uv, float lift, float skirt)
{
    base_position = position;
    world_position = position;
    if (lift > 0.0) world_position.y += lift * snow_at(position).x;
    base_normal = normal;
    base_colour = colour;
    picture_uv = uv;
    is_skirt = skirt;
    gl_Position = camera.projection * camera.view * vec4(world_position, 1.0);
}
