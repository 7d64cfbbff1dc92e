// Snow in light.

const vec3 snow_colour = vec3(0.90, 0.93, 0.97);
const float light_within = 0.15;  // how far light gets within it; see lit
const float grain_size = 1.28;    // m, after which its grain repeats
