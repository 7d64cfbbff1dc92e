// A winter afternoon: a low pale sun, and light from a grey sky above and from the ground below.

uniform vec3 eye;  // m, where the camera is
uniform vec3 fog;  // colour of the air, the same as the background's

// colour: of the surface, linear. Returns what is seen of it, ready for the screen.
vec3 lit(vec3 colour, vec3 normal, vec3 position)
{
    const vec3 to_sun = vec3(0.51, 0.56, 0.65);  // length 1, world space
    float sky = 0.5 + 0.5 * normal.y;            // fraction of the sky that the surface faces
    vec3 light = 0.75 * max(dot(normal, to_sun), 0.0) * vec3(1.0, 0.93, 0.82) +
                 mix(vec3(0.10, 0.10, 0.11), vec3(0.36, 0.42, 0.52), sky);
    float clear = exp(-0.016 * distance(eye, position));  // fraction of the light that the air lets through
    return mix(fog, sqrt(colour * light), clear);  // a screen shows about the square
}
