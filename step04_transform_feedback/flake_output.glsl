// The four outputs of an update shader, in the layout of a Particle, that transform feedback captures.

out vec3 position;
out float age;
out vec3 velocity;
out float rest;

void store_flake(Particle p)
{
    position = p.position;
    age = p.age;
    velocity = p.velocity;
    rest = p.rest;
}
