#include "common/harness/timing.hpp"

#include <algorithm>
#include <cstdio>
#include <iomanip>
#include <sstream>

using Clock = std::chrono::steady_clock;

void FrameTimer::begin_frame(bool synchronised)
{
    frames_.push_back({0, synchronised, {}});
    open_ = true;
}

void FrameTimer::end_frame(double frame_ms, size_t keep)
{
    if (!open_) return;
    frames_.back().frame_ms = frame_ms;
    open_ = false;
    collect(false);
    for (; frames_.size() > keep && collected_ > 0; --collected_) frames_.pop_front();
}

void FrameTimer::begin_stage(const char* name)
{
    if (!open_) return;
    FrameTime& frame = frames_.back();
    StageTime& stage = frame.stages.emplace_back();
    stage.name = name;
    if (frame.synchronised) {
        glFinish();
    } else if (GLEW_ARB_timer_query) {
        glGenQueries(2, stage.queries);
        glQueryCounter(stage.queries[0], GL_TIMESTAMP);
    }
    stage_begin_ = Clock::now();
}

void FrameTimer::end_stage()
{
    if (!open_) return;
    const auto milliseconds = [this] {
        return std::chrono::duration<double, std::milli>(Clock::now() - stage_begin_).count();
    };
    StageTime& stage = frames_.back().stages.back();
    stage.cpu_ms = milliseconds();
    if (frames_.back().synchronised) {
        glFinish();
        stage.gpu_ms = milliseconds();
    } else if (GLEW_ARB_timer_query) {
        glQueryCounter(stage.queries[1], GL_TIMESTAMP);
    }
}

void FrameTimer::finish()
{
    collect(true);
    if (open_) frames_.pop_back();
    open_ = false;
}

// Takes in the timestamps that have arrived. The queries are answered in the order in which they
// were made, so the first that is not ready ends it; asking for its result would stall until it is.
void FrameTimer::collect(bool wait)
{
    for (; collected_ < frames_.size(); ++collected_) {
        for (StageTime& stage : frames_[collected_].stages) {
            if (stage.queries[0] == 0) continue;
            GLint ready = wait;
            if (!wait) glGetQueryObjectiv(stage.queries[1], GL_QUERY_RESULT_AVAILABLE, &ready);
            if (!ready) return;
            GLuint64 begin = 0, end = 0;  // ns
            glGetQueryObjectui64v(stage.queries[0], GL_QUERY_RESULT, &begin);
            glGetQueryObjectui64v(stage.queries[1], GL_QUERY_RESULT, &end);
            // Some cards count with fewer than 64 bits, and begin anew after a minute.
            if (end >= begin) stage.gpu_ms = double(end - begin) * 1e-6;
            glDeleteQueries(2, stage.queries);
            stage.queries[0] = 0;
        }
    }
}

double quantile(std::vector<double> values, double fraction)
{
    if (values.empty()) return 0;
    const size_t rank = std::min(values.size() - 1, size_t(fraction * double(values.size())));
    std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(rank), values.end());
    return values[rank];
}

// The stages of all frames, each once, in the order in which they come.
static std::vector<std::string> stage_names(const std::deque<FrameTime>& frames)
{
    std::vector<std::string> names;
    for (const FrameTime& frame : frames) {
        for (const StageTime& stage : frame.stages) {
            if (std::find(names.begin(), names.end(), stage.name) == names.end())
                names.push_back(stage.name);
        }
    }
    return names;
}

static const StageTime* find_stage(const FrameTime& frame, const std::string& name)
{
    for (const StageTime& stage : frame.stages) {
        if (stage.name == name) return &stage;
    }
    return nullptr;
}

std::string csv_of(const std::deque<FrameTime>& frames, const CommandLine& command, glm::ivec2 size,
                   const std::string& renderer)
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
            << "," << size.x << "," << size.y << "," << std::quoted(renderer, '"', '"') << ","
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
    return csv.str();
}

void print_summary(const std::deque<FrameTime>& frames)
{
    std::vector<double> times;
    for (const FrameTime& frame : frames) {
        if (!frame.synchronised) times.push_back(frame.frame_ms);
    }
    const double median = quantile(times, 0.5);
    std::printf("benchmark: %zu frames, median %.3f ms (%.1f fps), p95 %.3f ms, "
                "worst 1 %% above %.3f ms\n",
                times.size(), median, 1000 / median, quantile(times, 0.95), quantile(times, 0.99));
    // Where there was a synchronised pass the queries do not cover all of a stage.
    const bool synchronised = times.size() < frames.size();
    for (const std::string& name : stage_names(frames)) {
        std::vector<double> cpu, gpu;
        for (const FrameTime& frame : frames) {
            const StageTime* stage = find_stage(frame, name);
            if (stage == nullptr || frame.synchronised != synchronised) continue;
            cpu.push_back(stage->cpu_ms);
            if (stage->gpu_ms) gpu.push_back(*stage->gpu_ms);
        }
        std::printf("  %-12s cpu %8.3f ms", name.c_str(), quantile(cpu, 0.5));
        const char* until = synchronised ? "until glFinish" : "gpu";
        if (!gpu.empty()) std::printf("   %s %8.3f ms", until, quantile(gpu, 0.5));
        std::puts("");
    }
    std::fflush(stdout);
}
