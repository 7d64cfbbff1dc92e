// One time step of one flake, as in step 4, with the scene in its way. What happens to it is counted.

#include "step04_transform_feedback/flake_state.glsl"
#include "step05_collision/release.glsl"
#include "step05_collision/ledger.glsl"

// What becomes of a flake p that has just moved in a straight line from `from`.
Particle collide(vec3 from, Particle p, Weather weather);

void main()
{
    uint index = uint(gl_VertexID);
    Particle p = settle(move(load_flake(), weather), weather);
    if (old_age >= 0.0 && old_rest == 0.0) p = collide(old_position, p, weather);
    p = accelerate(p, weather.wind, index, tick, weather);
    if (!goes_on(p, index) || gone(p, index, weather)) {
        if (old_age >= 0.0) count_end(melt_left(p, weather) < 0.0);
        if (release(p, index, tick)) count_release();
    }
    store_flake(p);
}
