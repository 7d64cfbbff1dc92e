// How a texel of 8 bits a channel tells what the snow looks like: red, how deep; green and blue, how it rises
// along x and z; alpha, that this is known. Where it is not, all is 0, and filtering weighs the others.

const float deep = 0.02;      // m: what is deeper looks no different
const float steepest = 1.5;   // rise, m for each m

vec4 texel_of(float depth, vec2 rise)
{
    return vec4(clamp(depth / deep, 0.0, 1.0), clamp(0.5 + 0.5 * rise / steepest, 0.0, 1.0), 1.0);
}

// x: depth, m, at most `deep`; y, z: rise.
vec3 snow_of(vec4 texel)
{
    if (texel.a < 0.01) return vec3(0.0);
    vec3 known = texel.rgb / texel.a;
    return vec3(deep * known.r, steepest * (2.0 * known.gb - 1.0));
}
