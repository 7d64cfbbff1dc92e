#include "common/harness/benchmark.hpp"

#include <algorithm>
#include <cstdio>
#include <iomanip>
#include <iostream>
#include <numeric>
#include <sstream>

#include "common/harness/files.hpp"

namespace {

// The stages of all frames, each once, in the order in which they come.
std::vector<std::string> stage_names(const std::deque<FrameTime>& frames)
{
    std::vector<std::string> names;
    for (const FrameTime& frame : frames) {
        for (const StageTime& stage : frame.stages) {
            if (std::find(names.begin(), names.end(), stage.name) == names.end()) {
                names.push_back(stage.name);
            }
        }
    }
    return names;
}

const StageTime* find_stage(const FrameTime& frame, const std::string& name)
{
    for (const StageTime& stage : frame.stages) {
        if (stage.name == name) return &stage;
    }
    return nullptr;
}

}  // namespace

Timing timing_of_frame(const CommandLine& command, uint64_t drawn, bool software)
{
    if (drawn >= command.warmup) return Timing::queries;
    // Software renderers answer some queries with 0: there the last frames of a benchmark's warm-up
    // are a pass of its own, in which the stages wait for each other and can be told apart.
    const unsigned pass = std::min(60u, command.warmup / 2);
    const bool synchronised = command.benchmark && software && drawn + pass >= command.warmup;
    return synchronised ? Timing::synchronised : Timing::off;
}

double quantile(std::vector<double> values, double fraction)
{
    if (values.empty()) return 0;
    const size_t rank = std::min(values.size() - 1, size_t(fraction * double(values.size())));
    std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(rank), values.end());
    return values[rank];
}

void write_csv(const std::filesystem::path& path, const CommandLine& command, glm::ivec2 size,
               const std::string& renderer, const std::deque<FrameTime>& frames)
{
    const std::vector<std::string> names = stage_names(frames);
    std::ostringstream csv;
    csv << std::fixed << std::setprecision(6)
        << "step,variant,particles,width,height,renderer,frame,frame_ms,timing";
    for (const std::string& name : names) csv << "," << name << "_cpu_ms," << name << "_gpu_ms";
    csv << "\n";
    size_t index[2] = {0, 0};  // of the frame, counted for either way of timing
    for (const FrameTime& frame : frames) {
        csv << command.lesson.name << "," << command.variant << "," << command.weather.particles
            << "," << size.x << "," << size.y << ",\"" << renderer << "\","
            << index[frame.synchronised]++ << "," << frame.frame_ms << ","
            << (frame.synchronised ? "finish" : "query");
        for (const std::string& name : names) {
            const StageTime* stage = find_stage(frame, name);
            csv << ",";
            if (stage) csv << stage->cpu_ms;
            csv << ",";
            if (stage && stage->gpu_ms) csv << *stage->gpu_ms;
        }
        csv << "\n";
    }
    write_file(path, csv.str());
}

void print_summary(const std::deque<FrameTime>& frames)
{
    std::vector<double> times;
    for (const FrameTime& frame : frames) {
        if (!frame.synchronised) times.push_back(frame.frame_ms);
    }
    if (times.empty()) {
        std::cout << "benchmark: no frame was measured" << std::endl;
        return;
    }
    const double median = quantile(times, 0.5),
                 total = std::accumulate(times.begin(), times.end(), 0.0);
    std::printf("benchmark: %zu frames in %.3f s: median %.3f ms (%.1f fps), p95 %.3f ms, "
                "worst 1 %% above %.3f ms\n",
                times.size(), total / 1000, median, 1000 / median, quantile(times, 0.95),
                quantile(times, 0.99));
    const bool synchronised = std::any_of(
        frames.begin(), frames.end(), [](const FrameTime& frame) { return frame.synchronised; });
    for (const std::string& name : stage_names(frames)) {
        std::vector<double> cpu, gpu;
        for (const FrameTime& frame : frames) {
            const StageTime* stage = find_stage(frame, name);
            if (stage == nullptr || frame.synchronised != synchronised) continue;
            cpu.push_back(stage->cpu_ms);
            if (stage->gpu_ms) gpu.push_back(*stage->gpu_ms);
        }
        std::printf("  %-12s cpu %8.3f ms", name.c_str(), quantile(cpu, 0.5));
        if (!gpu.empty()) {
            std::printf("   %s %8.3f ms", synchronised ? "until glFinish" : "gpu",
                        quantile(gpu, 0.5));
        }
        std::printf("\n");
    }
    std::printf("  timing a stage costs %.4f ms%s\n", FrameTimer::cost_of_a_stage(),
                synchronised
                    ? "; stages from a synchronised pass, as this renderer's queries do not "
                      "cover all of them"
                    : "");
    std::fflush(stdout);
}
