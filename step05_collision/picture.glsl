// The picture on a surface of the scene; a white one where it has none.

uniform sampler2D picture;

in vec2 picture_uv;

// colour: of the surface without it, linear. What is cut out of the picture is not drawn at all.
vec3 with_picture(vec3 colour)
{
    vec4 texel = texture(picture, picture_uv);
    if (texel.a < 0.5) discard;
    return colour * texel.rgb * texel.rgb;  // made for a screen, which shows about the square
}
