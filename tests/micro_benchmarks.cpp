// What the parts that run on the CPU can do, apart from any frame:
// `tests/micro_benchmarks --help` lists the options (--benchmark_filter=update picks some).
// Nothing here opens a window.

#include <benchmark/benchmark.h>

#include <cstring>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <vector>

#include "common/harness/files.hpp"
#include "common/scene/scene.hpp"
#include "common/weather.hpp"
#include "step01_cpu_points/update.hpp"
#include "step05_collision/voxel_grid.hpp"

using namespace snow;

namespace {

// Keeps what the code under test says about a scene from being said a thousand times.
class Silence {
public:
    Silence() : spoken_(std::cout.rdbuf(nowhere_.rdbuf())) {}
    ~Silence() { std::cout.rdbuf(spoken_); }
    Silence(const Silence&) = delete;
    Silence& operator=(const Silence&) = delete;

private:
    std::ostringstream nowhere_;
    std::streambuf* spoken_;
};

// Flakes and bytes per second, and the time of one flake, from the flakes of one iteration.
void count_flakes(benchmark::State& state, size_t flakes)
{
    const auto all = double(flakes) * double(state.iterations());
    state.SetBytesProcessed(int64_t(all * sizeof(Particle)));
    state.counters["per_flake"] =
        benchmark::Counter(all, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

// ---- Moving flakes against moving nothing but their bytes: where the two meet, memory is what
// the update waits for.

template <void (*update)(std::span<Particle>, uint, Weather)>
void update_flakes(benchmark::State& state)
{
    const Weather weather = make_weather("snow", uint(state.range(0)), 1);
    // As many are born in each step from the first on as later, so no warm-up is needed.
    std::vector<Particle> flakes = make_flakes(weather);
    uint step = 0;
    for (auto _ : state) {
        update(flakes, step++, weather);
        benchmark::ClobberMemory();
    }
    count_flakes(state, flakes.size());
}

void copy_flakes(benchmark::State& state)
{
    const Weather weather = make_weather("snow", uint(state.range(0)), 1);
    const std::vector<Particle> flakes = make_flakes(weather);
    std::vector<Particle> copy(flakes.size());
    for (auto _ : state) {
        std::memcpy(copy.data(), flakes.data(), flakes.size() * sizeof(Particle));
        benchmark::ClobberMemory();
    }
    count_flakes(state, flakes.size());
}

BENCHMARK(update_flakes<update_in_one_loop>)
    ->Name("update_in_one_loop")
    ->RangeMultiplier(10)
    ->Range(1'000, 10'000'000)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(update_flakes<update_in_three_loops>)
    ->Name("update_in_three_loops")
    ->RangeMultiplier(10)
    ->Range(1'000, 10'000'000)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(copy_flakes)
    ->Name("memcpy")
    ->RangeMultiplier(10)
    ->Range(1'000, 10'000'000)
    ->Unit(benchmark::kMicrosecond);

// ---- Scenes, at the start of steps 5 and 6.

void voxelise_courtyard(benchmark::State& state)
{
    const Silence silence;
    const Scene scene = load_scene(find_file("common/assets/courtyard.obj"), 'y');
    for (auto _ : state) benchmark::DoNotOptimize(voxelise(scene, int(state.range(0))));
    const size_t triangles = scene.indices.size() / 3;
    state.counters["triangles"] = benchmark::Counter(double(triangles) * double(state.iterations()),
                                                     benchmark::Counter::kIsRate);
}

void load_courtyard(benchmark::State& state)
{
    const Silence silence;
    const std::filesystem::path path = find_file("common/assets/courtyard.obj");
    for (auto _ : state) benchmark::DoNotOptimize(load_scene(path, 'y'));
    state.SetBytesProcessed(int64_t(std::filesystem::file_size(path)) * state.iterations());
}

BENCHMARK(voxelise_courtyard)
    ->ArgName("resolution")
    ->RangeMultiplier(2)
    ->Range(64, 512)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(load_courtyard)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
