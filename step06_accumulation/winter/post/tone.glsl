// What the screen is to show of the frame's light.

uniform sampler2D frame;  // as LinearFrame holds it
uniform float exposure;

// The numbers, 0 to 1, that the screen is told for such light. They never get to 1, so however bright, snow
// keeps its shades. An eye answers to light x times as strong as what it answers to by half, here 0.65, by
// x^n / (1 + x^n), here with n = 1.25 (Naka and Rushton 1966; for pictures: Reinhard and Devlin, "Dynamic range
// reduction inspired by photoreceptor physiology", 2005). A screen that is to shine so brightly is told about
// the 2.4th root of it (sRGB, IEC 61966-2-1). Powers would cost more than all the rest: this is a fit to both
// together, with one square root, off by no more than 3.3 of 255.
vec3 for_screen(vec3 radiance)
{
    vec3 x = 3.5 * exposure * max(radiance, 0.0), root = sqrt(x);
    return (0.18 * root + x) / (1.0 + 0.1 * root + x);
}
