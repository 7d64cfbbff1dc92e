// Lifts a point of the scene by the snow that lies on it, and hands it on to surface.frag.

#include "common/weather_block.glsl"
#include "step06_accumulation/cover/snow_depth.glsl"
#include "step06_accumulation/winter/light/air.glsl"
#include "step06_accumulation/winter/surface/corner.glsl"

invariant gl_Position;  // tessellated or not, along an edge that both kinds of triangles share

out Spot spot;  // see surface.frag
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
    const float margin = 0.2;  // m within the edge, along which the snow becomes that of the field
    vec2 half_size = vec2(0.5 * grid.cell_size * float(grid.resolution));
    vec2 outside = abs(corner.position.xz - grid.origin.xz - half_size) - half_size;
    float away = max(outside.x, outside.y);  // from the edge of the grid
    beyond = smoothstep(-margin, 0.0, away);
    base = across_grid(corner.position).y;
    // Snow cannot slide out of the grid, and would pile up at a wall on its edge: no more of it is drawn than
    // would be left if it could.
    float most = frame.field_depth + tan(radians(weather.repose)) * max(-away, 0.0);
    float depth = min(mix(depth_at(corner.position), frame.field_depth, beyond), most);
    vec3 world_position = corner.position + vec3(0.0, corner.displacement * depth, 0.0);
    float filled = smoothstep(0.0, 0.3, depth);
    base_normal = mix(corner.normal, corner.even_normal, filled);
    evened = filled * smoothstep(0.0, 0.05, distance(corner.normal, corner.even_normal));
    spot = spot_at(world_position, base_normal);
    base_colour = corner.colour;
    picture_uv = corner.uv;
    is_skirt = corner.skirt;
    air = air_before(world_position);
    gl_Position = frame.projection * frame.view * vec4(world_position, 1.0);
}
