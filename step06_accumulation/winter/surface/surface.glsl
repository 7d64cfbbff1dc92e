// Lifts a point of the scene by the snow that lies on it, and hands it on to look.glsl.

#include "common/weather_block.glsl"
#include "step06_accumulation/winter/light/air.glsl"
#include "step06_accumulation/winter/surface/smooth_depth.glsl"

invariant gl_Position;  // tessellated or not, along an edge that both kinds of triangles share

out vec3 base_position;  // see look.glsl
out vec3 world_position;
out vec3 base_normal;
out vec3 base_colour;
out vec2 picture_uv;
out float is_skirt;
out float evened;
out float beyond;
out vec4 air;

// even: normal and height of the surface when its hollows are filled, see hollows.hpp.
void put_on_snow(vec3 position, vec3 normal, vec3 colour, vec2 uv, float lift, float skirt, vec4 even)
{
    const float margin = 1.0;  // m, along which the snow becomes that of the field
    vec2 half_size = vec2(0.5 * cell_size * float(resolution));
    vec2 outside = abs(position.xz - grid_origin.xz - half_size) - half_size;
    float away = max(outside.x, outside.y);  // from the edge of the grid
    beyond = smoothstep(0.0, margin, away);
    base_position = position;
    world_position = position;
    // Snow cannot slide out of the grid, and would pile up at a wall on its edge: drawn is what would be left
    // if it could.
    float most = camera.field_depth + tan(radians(weather.repose)) * max(-away, 0.0);
    float depth = min(mix(snow_at(position).x, camera.field_depth, beyond), most);
    const float filling = 0.3;  // m of snow that fill all hollows
    float filled = lift * smoothstep(0.0, filling, depth);
    world_position.y += lift * depth + filled * even.w;
    base_normal = skirt > 0.0 ? normal : mix(normal, even.xyz, filled);
    evened = filled * smoothstep(0.0, 0.05, distance(normal, even.xyz));
    base_colour = colour;
    picture_uv = uv;
    is_skirt = skirt;
    air = air_before(world_position);
    gl_Position = camera.projection * camera.view * vec4(world_position, 1.0);
}
