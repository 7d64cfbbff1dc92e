// Hands a point of the scene on to the screen, lifted by the snow that lies on it.

float depth_at(vec3 point);  // m, of the snow there

uniform mat4 view;
uniform mat4 projection;

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 colour;
layout(location = 3) in vec2 uv;

out vec3 bare_position;   // m, of the scene without snow
out vec3 world_position;  // m, on top of the snow
out vec3 world_normal;
out vec3 base_colour;
out vec2 picture_uv;

void main()
{
    bare_position = position;
    world_position = position + vec3(0.0, depth_at(position), 0.0);
    world_normal = normal;
    base_colour = colour;
    picture_uv = uv;
    gl_Position = projection * view * vec4(world_position, 1.0);
}
