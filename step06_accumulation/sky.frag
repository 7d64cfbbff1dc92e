#version 430 core
// What lies behind the scene: the sky, and the field around the courtyard, which whitens as it snows.

#include "step06_accumulation/light.glsl"

out vec4 colour;

void main()
{
    vec2 place = 2.0 * gl_FragCoord.xy / vec2(frame.window_size) - 1.0;  // clip space
    vec4 far_point = inverse(frame.projection * frame.view) * vec4(place, 1.0, 1.0);
    vec3 direction = normalize(far_point.xyz / far_point.w - frame.eye);
    vec3 radiance = mix(air_light(direction), light.zenith, smoothstep(0.0, 0.5, direction.y));
    if (direction.y < 0.0) {
        vec3 point = frame.eye - direction * (frame.eye.y / direction.y);  // where the line of sight meets y = 0
        vec3 field = mix(vec3(0.20, 0.21, 0.17), vec3(0.90, 0.93, 0.97), smoothstep(0.0, 0.02, frame.field_depth));
        radiance = through_air(lit(field, vec3(0.0, 1.0, 0.0), point), point);
    }
    colour = vec4(tone_mapped(radiance), 1.0);
}
