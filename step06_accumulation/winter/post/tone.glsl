// What the screen is to show of the frame's light, 0 to 1.

uniform sampler2D frame;  // as LinearFrame holds it
uniform float exposure;

// It never gets to 1, so however bright, snow keeps its shades. The curve is that by which an eye answers to
// light (Naka and Rushton 1966; for pictures: Reinhard and Devlin, "Dynamic range reduction inspired by
// photoreceptor physiology", 2005), with an exponent that takes two square roots, as a power would cost more
// than all the rest.
vec3 answer_to(vec3 radiance)
{
    const float half_way = 0.65;  // radiance of what is to be half as bright as the screen can be
    vec3 x = exposure / half_way * max(radiance, 0.0);
    vec3 answer = x * sqrt(sqrt(x));
    return answer / (1.0 + answer);
}

// The numbers by which a screen is told to shine so brightly (sRGB, IEC 61966-2-1): a fit by square roots,
// exact to 1/2000 but for what is all but black.
vec3 for_screen(vec3 linear)
{
    vec3 s1 = sqrt(linear), s2 = sqrt(s1), s3 = sqrt(s2);
    return clamp(0.6620 * s1 + 0.6841 * s2 - 0.3236 * s3 - 0.0225 * linear, 0.0, 1.0);
}
