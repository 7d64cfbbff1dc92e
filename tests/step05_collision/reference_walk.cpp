// Step 5 on the CPU, without a window: the same options, the same physics, the same walk through
// the voxels, written as plainly as can be. test_collision.py compares its dump with the program's.
#include <iostream>

#include "common/harness/options.hpp"
#include "common/harness/output.hpp"
#include "common/scene/scene.hpp"
#include "step05_collision/voxel_grid.hpp"

namespace snow {

VoxelGrid grid;

bool solid(ivec3 cell)
{
    return grid.solid(cell);
}

#include "step05_collision/voxel_walk.glsl"

#include "step05_collision/open_sky.glsl"

Particle one_step(const Particle& old, uint index, uint step, const Weather& weather)
{
    Particle p = settle(move(old, weather), weather);
    if (airborne(old)) p = collide(old.position, p, weather);
    p = accelerate(p, weather.wind, index, step, weather);
    if (!gone(p, index, weather)) return p;
    p = born(index, step, weather);
    if (!wind_takes_flakes(weather) || open_sky(p.position)) return p;
    p = unborn(index, weather);
    p.age = -weather.time_step;
    return p;
}

}  // namespace snow

int main(int argc, char** argv)
try {
    const CommandLine options = parse_command_line(argc, argv,
                                                   {.name = "reference_walk",
                                                    .idea = "step 5 on the CPU, for the tests",
                                                    .minimum_gl = 0,
                                                    .variants = {{"voxels", nullptr}},
                                                    .has_scene = true});
    snow::grid =
        voxelise(load_scene(options.scene, options.up, nullptr, options.metres), options.voxels);

    std::vector<snow::Particle> flakes = make_flakes(options.weather);
    for (unsigned step = 0; step < options.frames.value_or(300); ++step) {
        for (unsigned i = 0; i < flakes.size(); ++i) {
            flakes[i] = one_step(flakes[i], i, step, options.weather);
        }
    }
    write_dump(options.dump, flakes);
    return 0;
} catch (const std::exception& failure) {
    std::cerr << failure.what() << std::endl;
    return 1;
}
