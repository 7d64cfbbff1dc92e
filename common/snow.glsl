// The physics of the snowfall, once for all six programs: every line here is both GLSL 3.30 and
// C++20 (under "using namespace glm"). Steps 1-3 compile it into their CPU loops through snow.hpp,
// steps 4-6 into their update shaders through #include. SI units: m, s, m/s, m/s2; y is up; the
// ground is y = 0.

#ifdef __cplusplus
// A loop is vectorised only if every function that it calls is inlined: compilers would stop at the
// third loop, and the default's would take 16 ns a flake, not 4.
#define SNOW_INLINE [[gnu::always_inline]] inline
#define SNOW_IN(type) const type&  // not a copy; GLSL has no references
#else
#define SNOW_INLINE
#define SNOW_IN(type) type
#endif

const uint snow_kind = 0u, rain_kind = 1u, hail_kind = 2u;

struct Particle {
    vec3 position;  // m
    float age;      // s since birth; negative while the flake waits for its first birth
    vec3 velocity;  // m/s
    float rest;     // s lying on a surface; 0 while airborne
};

struct Emitter {           // a cloud: a box in which flakes are born
    vec3 centre;           // m
    float terminal_speed;  // m/s at which drag balances gravity
    vec3 half_size;        // m
    float diameter;        // m, of a flake as it is drawn
};

// std140 and C++ lay this out alike because every vec3 is followed by one float, and the array
// begins at a multiple of 16 bytes.
struct Weather {
    vec3 gravity;      // m/s2
    float turbulence;  // m/s2, largest random push along each axis
    vec3 wind;         // m/s
    float melt_time;   // s a flake lies on a surface before it is gone
    float world_min;   // m, heights between which a flake is not lost
    float world_max;
    float time_step;   // s
    float lifetime;    // s in the air, mean; most reach the ground before
    uint particles;    // in the pool: the first half is of emitter 0, the rest of emitter 1
    uint seed;
    float variation;    // relative spread of speed and diameter from flake to flake
    float snowfall;     // m of depth a minute that lie on open ground, where snow accumulates
    float temperature;  // degrees Celsius; above 0 the snow that lies melts
    float repose;       // degrees, the steepest slope on which snow lies (its angle of repose)
    float restitution;  // fraction of its speed that a flake keeps when it bounces
    uint kind;          // snow, rain or hail, as above
    float swirl;        // m/s, largest speed of the air's vortices along each axis
    float vortex_size;  // m
    uint follow;        // 1: the clouds go where the camera goes, see wrapped
    uint unused;        // fills the row of four
    Emitter emitters[2];
};

// ---- Random numbers: a hash of the flake's index and the time step. They need no state, and agree
// on CPU and GPU.

// Mixes all bits of x into all bits of the result (constants: Wellons' "hash prospector" search).
SNOW_INLINE uint hash(uint x)
{
    x = (x ^ (x >> 16u)) * 0x21f0aaadu;
    x = (x ^ (x >> 15u)) * 0xd35a2d97u;
    return x ^ (x >> 15u);
}

// 32 random bits for flake `index` at time step `tick`; each use has a `stream` of its own.
SNOW_INLINE uint random_bits(uint index, uint tick, uint stream, SNOW_IN(Weather) weather)
{
    return hash(index ^ hash(tick * 8u + stream + weather.seed * 0x9e3779b9u));
}

// Uniform in [0, 1): the upper 24 bits, as many as a float holds exactly.
SNOW_INLINE float random_unit(uint index, uint tick, uint stream, SNOW_IN(Weather) weather)
{
    return float(random_bits(index, tick, stream, weather) >> 8u) * (1.0f / 16777216.0f);
}

// ---- What never changes in a flake: functions of its index alone.

SNOW_INLINE bool of_first_emitter(uint index, SNOW_IN(Weather) weather)
{
    return index < weather.particles / 2u;
}

SNOW_INLINE Emitter emitter_of(uint index, SNOW_IN(Weather) weather)
{
    return of_first_emitter(index, weather) ? weather.emitters[0] : weather.emitters[1];
}

// 1 give or take the variation; one number for speed and diameter: large flakes fall faster.
SNOW_INLINE float individuality(uint index, SNOW_IN(Weather) weather)
{
    return 1.0f + weather.variation * (2.0f * random_unit(index, 0u, 0u, weather) - 1.0f);
}

SNOW_INLINE float terminal_speed(uint index, SNOW_IN(Weather) weather)  // m/s
{
    return emitter_of(index, weather).terminal_speed * individuality(index, weather);
}

SNOW_INLINE float diameter(uint index, SNOW_IN(Weather) weather)  // m
{
    return emitter_of(index, weather).diameter * individuality(index, weather);
}

// How long a flake lives in the air, s, if it does not come down before: then it has sublimated,
// turned to vapour on its way. The mean is far longer than the way down, but lifetimes differ by
// nearly all of the mean, so some flakes never land.
const float lifetime_spread = 0.9f;  // relative
SNOW_INLINE float lifetime(uint index, SNOW_IN(Weather) weather)
{
    float spread = lifetime_spread * (2.0f * random_unit(index, 0u, 6u, weather) - 1.0f);
    return weather.lifetime * (1.0f + spread);
}

// The fraction of all flakes that lives longer than that many seconds.
SNOW_INLINE float part_alive(float seconds, SNOW_IN(Weather) weather)
{
    return clamp(0.5f + (1.0f - seconds / weather.lifetime) / (2.0f * lifetime_spread), 0.0f, 1.0f);
}

// ---- Birth.

// Does wind blow flakes out of the air below their clouds? Not where that repeats: see wrapped.
SNOW_INLINE bool wind_takes_flakes(SNOW_IN(Weather) weather)
{
    return weather.follow == 0u && (weather.wind.x != 0.0f || weather.wind.z != 0.0f);
}

// A flake at a random position in its cloud, drifting with the air. In wind there are flakes in the
// air that comes in, too, at any height: as many more as that is more than what falls out of the
// cloud. So the air above the scene is as full of flakes in any wind.
SNOW_INLINE Particle born(uint index, uint tick, SNOW_IN(Weather) weather)
{
    Emitter cloud = emitter_of(index, weather);
    vec3 corner = vec3(random_unit(index, tick, 1u, weather), random_unit(index, tick, 2u, weather),
                       random_unit(index, tick, 3u, weather));
    Particle p;
    p.position = cloud.centre + cloud.half_size * (2.0f * corner - 1.0f);
    p.age = 0.0f;
    p.velocity = weather.wind;
    p.rest = 0.0f;
    if (!wind_takes_flakes(weather)) return p;

    float speed = terminal_speed(index, weather), height = cloud.centre.y;
    float above = 4.0f * cloud.half_size.x * cloud.half_size.z * speed;  // m3/s, as are the others
    float along_x = 2.0f * height * cloud.half_size.z * abs(weather.wind.x);
    float along_z = 2.0f * height * cloud.half_size.x * abs(weather.wind.z);
    float way_in = (above + along_x + along_z) * random_unit(index, tick, 7u, weather);
    if (way_in >= along_x + along_z) return p;
    vec3 upwind = cloud.centre - cloud.half_size * sign(weather.wind);
    if (way_in < along_x) {
        p.position.x = upwind.x;
    } else {
        p.position.z = upwind.z;
    }
    p.position.y = height * corner.y;
    p.velocity.y -= speed;  // it has been falling, and for as long as it is below its cloud
    p.age = (height - p.position.y) / speed;
    return p;
}

// Before its first birth a flake waits, out of sight above the world, at a negative age. It waits a
// random fraction of the cycle from one birth to the next: if all flakes came in a burst, they
// would be gone together and leave a gap. It also waits a random fraction of half the way down, or
// the first flakes would be a front with all the snow right behind it. So the births of a second
// grow in proportion to the time, and then stay as many (Patrick 2000, 4.2.2.2: start thin): the
// rate is what two even distributions of waiting times make together.
SNOW_INLINE Particle unborn(uint index, SNOW_IN(Weather) weather)
{
    float fall = emitter_of(index, weather).centre.y / terminal_speed(index, weather);
    float life = lifetime(index, weather);
    float cycle = life < fall ? life : fall + weather.melt_time;
    Particle p;
    p.position = vec3(0.0f, weather.world_max + 1000.0f, 0.0f);
    p.age = -cycle * random_unit(index, 0u, 4u, weather) -
            0.5f * fall * random_unit(index, 0u, 7u, weather);
    p.velocity = vec3(0.0f);
    p.rest = 0.0f;
    return p;
}

// ---- The air.

// The velocity that vortices add to the wind, m/s; the wind carries them along. Air neither piles
// up nor comes out of the ground: the divergence is 0 everywhere (its term along x is in proportion
// to c.x (c.y - c.z), and the three cancel), and so is the speed along y at y = 0. s is much like a
// sine, and c like its slope, but both are made of parabolas: a sine differs from card to card, and
// would keep the CPU's loops from being vectorised.
SNOW_INLINE vec3 vortices(vec3 position, uint tick, SNOW_IN(Weather) weather)
{
    // Vortices drift in calm air, too, or flakes would gather in lines that stay where they are.
    vec3 drift = weather.wind + weather.swirl * vec3(0.3f, 0.0f, 0.2f);
    vec3 turns = position - float(tick) * weather.time_step * drift;
    turns /= 2.0f * weather.vortex_size;
    turns -= floor(turns + 0.5f);  // -1/2 to 1/2, over two vortices of opposite sense
    vec3 c = 1.0f - 4.0f * abs(turns);
    vec3 s = 4.0f * turns * (1.0f + c);
    return 0.5f * weather.swirl * s * vec3(c.y - c.z, c.z - c.x, c.x - c.y);
}

// ---- One time step of the motion, in the order move, settle, (collide,) accelerate, gone -> born.

SNOW_INLINE bool airborne(Particle p)
{
    // It means p.age >= 0 && p.rest == 0. With that && the CPU's loop is not vectorised, and takes
    // 11 ns a flake, not 4.
    return (p.age >= 0.0f ? p.rest : 1.0f) == 0.0f;
}

// Explicit Euler, first half: p' = p + dt v. A flake that waits or lies has velocity zero.
SNOW_INLINE Particle move(Particle p, SNOW_IN(Weather) weather)
{
    p.age += weather.time_step;
    p.position += weather.time_step * p.velocity;
    return p;
}

// The fraction of its speed that a flake keeps when it comes down on a surface: 0, and it stays
// there, unless it is fast enough to bounce.
SNOW_INLINE float speed_kept(Particle p, SNOW_IN(Weather) weather)
{
    const float least_rebound = 0.5f;  // m/s
    return -weather.restitution * p.velocity.y < least_rebound ? 0.0f : weather.restitution;
}

// A flake that has come down on a surface.
SNOW_INLINE Particle land(Particle p, SNOW_IN(Weather) weather)
{
    if (p.velocity.y > 0.0f) return p;  // it has just bounced, off the ground under the surface
    float kept = speed_kept(p, weather);
    p.velocity *= vec3(kept, -kept, kept);
    p.rest = kept > 0.0f ? 0.0f : weather.time_step;
    return p;
}

// A flake that reaches the ground lands on it; one that lies grows older there.
SNOW_INLINE Particle settle(Particle p, SNOW_IN(Weather) weather)
{
    bool on_ground = airborne(p) && p.position.y <= 0.0f;
    // Both speeds are worked out for every flake: inside an if (on_ground) they would keep the
    // CPU's loop from being vectorised, 11 ns a flake, not 4.
    float bounce = speed_kept(p, weather);
    float kept = on_ground ? bounce : 1.0f;
    float moving = p.rest > 0.0f ? 0.0f : kept;
    if (moving == 0.0f) p.rest += weather.time_step;
    if (on_ground) p.position.y = 0.0f;
    p.velocity *= vec3(kept, on_ground ? -kept : kept, kept);
    return p;
}

// Explicit Euler, second half: v' = v + dt (a + r). a is gravity less the drag of the air,
// quadratic in the speed u relative to it and equal to gravity at terminal speed:
// a = g - |g| |u| u / terminal^2. r is a random push that lasts 16 steps, the flutter of a flake.
// air: its velocity around the flake without vortices, m/s; weather.wind where that blows evenly.
SNOW_INLINE Particle accelerate(Particle p, vec3 air, uint index, uint tick,
                                SNOW_IN(Weather) weather)
{
    float terminal = terminal_speed(index, weather);
    vec3 u = p.velocity - air;
    if (weather.swirl != 0.0f) u -= vortices(p.position, tick, weather);
    // No drag stops a flake in less than one time step: beyond that limit Euler's method would
    // overshoot and, in a strong gust, explode.
    float drag =
        min(length(weather.gravity) * length(u) / (terminal * terminal), 1.0f / weather.time_step);
    uint bits = random_bits(index, tick / 16u, 5u, weather);
    vec3 push =
        vec3(float(bits & 1023u), float((bits >> 10u) & 1023u), float((bits >> 20u) & 1023u));
    vec3 r = weather.turbulence * (push * (2.0f / 1023.0f) - 1.0f);
    p.velocity += (airborne(p) ? weather.time_step : 0.0f) * (weather.gravity - drag * u + r);
    return p;
}

// Where the clouds go with the camera, the air under each repeats itself for ever along x and z: a
// flake that the wind blows out on one side, or that a cloud leaves behind, comes in on the other,
// as if it had long been falling there. It is the same flake: nothing has left, nothing is
// released. A flake that lies stays where it fell.
SNOW_INLINE Particle wrapped(Particle p, uint index, SNOW_IN(Weather) weather)
{
    if (weather.follow == 0u || !airborne(p)) return p;
    Emitter cloud = emitter_of(index, weather);
    vec3 width = 2.0f * cloud.half_size;
    vec3 widths = floor((p.position - cloud.centre) / width + 0.5f);
    p.position -= width * vec3(widths.x, 0.0f, widths.z);
    return p;
}

// The rest of a flake's time on a surface, s.
SNOW_INLINE float melt_left(Particle p, SNOW_IN(Weather) weather)
{
    return weather.melt_time - p.rest;
}

// The rest of a flake's lifetime (s), which the time it lies does not count towards, or of its way
// out of the world (m), whichever is less. A waiting flake is outside the world.
SNOW_INLINE float life_left(Particle p, uint index, SNOW_IN(Weather) weather)
{
    float way = min(p.position.y - weather.world_min, weather.world_max - p.position.y);
    if (wind_takes_flakes(weather)) {
        Emitter cloud = emitter_of(index, weather);
        vec3 inside = cloud.half_size - abs(p.position - cloud.centre);
        way = min(way, min(inside.x, inside.z));
    }
    return min(lifetime(index, weather) - (p.age - p.rest), way);
}

SNOW_INLINE bool gone(Particle p, uint index, SNOW_IN(Weather) weather)
{
    if (p.age < 0.0f) return false;  // it waits
    return min(melt_left(p, weather), life_left(p, index, weather)) < 0.0f;
}

// A whole time step of a flake in the open.
SNOW_INLINE Particle advance(Particle p, uint index, uint tick, SNOW_IN(Weather) weather)
{
    p = accelerate(settle(move(p, weather), weather), weather.wind, index, tick, weather);
    if (gone(p, index, weather)) p = born(index, tick, weather);
    return p;
}
