// Lifts a point of the scene by the snow that lies on it, and hands it on to look.glsl.

#include "common/weather_block.glsl"
#include "step06_accumulation/winter/light/air.glsl"
#include "step06_accumulation/winter/surface/corner.glsl"
#include "step06_accumulation/winter/surface/smooth_depth.glsl"

invariant gl_Position;  // tessellated or not, along an edge that both kinds of triangles share

out Place place;     // see look.glsl
out float base;
out vec3 base_normal;
out vec3 base_colour;
out vec2 picture_uv;
out float is_skirt;
out float evened;
out float beyond;
out vec4 air;

void put_on_snow(Corner corner)
{
    const float margin = 1.0;  // m, along which the snow becomes that of the field
    vec2 half_size = vec2(0.5 * cell_size * float(resolution));
    vec2 outside = abs(corner.position.xz - grid_origin.xz - half_size) - half_size;
    float away = max(outside.x, outside.y);  // from the edge of the grid
    beyond = smoothstep(0.0, margin, away);
    base = across_grid(corner.position).y;
    // Snow cannot slide out of the grid, and would pile up at a wall on its edge: drawn is what would be left
    // if it could.
    float most = camera.field_depth + tan(radians(weather.repose)) * max(-away, 0.0);
    float depth = min(mix(snow_at(corner.position).x, camera.field_depth, beyond), most);
    const float filling = 0.3;  // m of snow that fill all hollows
    float filled = corner.lift * smoothstep(0.0, filling, depth);
    vec3 world_position = corner.position;
    world_position.y += corner.lift * depth + filled * corner.even.w;
    base_normal = corner.skirt > 0.0 ? corner.normal : mix(corner.normal, corner.even.xyz, filled);
    place = place_of(world_position, base_normal);
    evened = filled * smoothstep(0.0, 0.05, distance(corner.normal, corner.even.xyz));
    base_colour = corner.colour;
    picture_uv = corner.uv;
    is_skirt = corner.skirt;
    air = air_before(world_position);
    gl_Position = camera.projection * camera.view * vec4(world_position, 1.0);
}
