#version 330 core
// A soft white disc: opaque in the middle, fading along the radius.

in float coverage;
out vec4 colour;

void main()
{
    // gl_PointCoord runs from (0, 0) to (1, 1) across the sprite.
    float radius = 2.0 * length(gl_PointCoord - 0.5);  // 0 in the centre, 1 at the edge
    if (radius > 1.0) discard;                          // the corners of the square
    colour = vec4(vec3(1.0), coverage * (1.0 - radius * radius));
}
