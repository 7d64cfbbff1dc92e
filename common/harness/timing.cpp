#include "common/harness/timing.hpp"

#include <algorithm>
#include <cstdio>
#include <iomanip>
#include <numeric>
#include <sstream>
#include <stdexcept>

namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point begin)
{
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

// From one timestamp to another, ms. Some cards count nanoseconds with fewer than 64 bits, and
// begin anew after a minute.
double milliseconds_between(GLuint64 begin, GLuint64 end)
{
    static const GLint bits = [] {
        GLint count = 0;
        glGetQueryiv(GL_TIMESTAMP, GL_QUERY_COUNTER_BITS, &count);
        return count;
    }();
    const GLuint64 mask = bits > 0 && bits < 64 ? (GLuint64(1) << bits) - 1 : ~GLuint64(0);
    return double((end - begin) & mask) * 1e-6;
}

// The stages of all frames, each once, in the order in which they come.
std::vector<std::string> stage_names(const std::deque<FrameTime>& frames)
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

const StageTime* find_stage(const FrameTime& frame, const std::string& name)
{
    for (const StageTime& stage : frame.stages) {
        if (stage.name == name) return &stage;
    }
    return nullptr;
}

// What timing one stage costs, ms, measured by timing a thousand empty ones.
double cost_of_a_stage()
{
    constexpr int count = 1000;
    FrameTimer timer;
    timer.begin_frame(false);
    const Clock::time_point begin = Clock::now();
    for (int i = 0; i < count; ++i) {
        timer.begin_stage("empty");
        timer.end_stage();
    }
    const double cost = milliseconds_since(begin) / count;
    timer.finish();
    return cost;
}

}  // namespace

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
    for (; frames_.size() > keep; ++forgotten_) frames_.pop_front();
}

void FrameTimer::begin_stage(const char* name)
{
    if (!open_) return;
    if (running_) throw std::logic_error(std::string("stage ") + name + " within a stage");
    running_ = true;
    FrameTime& frame = frames_.back();
    frame.stages.push_back({name, 0, {}});
    if (frame.synchronised) {
        glFinish();
    } else if (GLEW_ARB_timer_query) {
        pending_.push_back({forgotten_ + frames_.size() - 1, frame.stages.size() - 1, {}});
        glGenQueries(2, pending_.back().queries);
        glQueryCounter(pending_.back().queries[0], GL_TIMESTAMP);
    }
    stage_begin_ = Clock::now();
}

void FrameTimer::end_stage()
{
    if (!running_) return;
    running_ = false;
    StageTime& stage = frames_.back().stages.back();
    stage.cpu_ms = milliseconds_since(stage_begin_);
    if (frames_.back().synchronised) {
        glFinish();
        stage.gpu_ms = milliseconds_since(stage_begin_);
    } else if (GLEW_ARB_timer_query) {
        glQueryCounter(pending_.back().queries[1], GL_TIMESTAMP);
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
    while (!pending_.empty()) {
        const Pending& oldest = pending_.front();
        GLint ready = 0;
        if (!wait) glGetQueryObjectiv(oldest.queries[1], GL_QUERY_RESULT_AVAILABLE, &ready);
        if (!wait && !ready) return;
        GLuint64 begin = 0, end = 0;  // ns
        glGetQueryObjectui64v(oldest.queries[0], GL_QUERY_RESULT, &begin);
        glGetQueryObjectui64v(oldest.queries[1], GL_QUERY_RESULT, &end);
        if (oldest.frame >= forgotten_) {
            frames_[oldest.frame - forgotten_].stages[oldest.stage].gpu_ms =
                milliseconds_between(begin, end);
        }
        glDeleteQueries(2, oldest.queries);
        pending_.pop_front();
    }
}

double quantile(std::vector<double> values, double fraction)
{
    if (values.empty()) return 0;
    const size_t rank = std::min(values.size() - 1, size_t(fraction * double(values.size())));
    std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(rank), values.end());
    return values[rank];
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
    if (times.empty()) {
        std::puts("benchmark: no frame was measured");
        return;
    }
    const double median = quantile(times, 0.5),
                 total = std::accumulate(times.begin(), times.end(), 0.0);
    std::printf("benchmark: %zu frames in %.3f s: median %.3f ms (%.1f fps), p95 %.3f ms, "
                "worst 1 %% above %.3f ms\n",
                times.size(), total / 1000, median, 1000 / median, quantile(times, 0.95),
                quantile(times, 0.99));
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
        if (!gpu.empty()) {
            std::printf("   %s %8.3f ms", synchronised ? "until glFinish" : "gpu",
                        quantile(gpu, 0.5));
        }
        std::printf("\n");
    }
    std::printf("  timing a stage costs %.4f ms%s\n", cost_of_a_stage(),
                synchronised
                    ? "; stages from a synchronised pass, as this renderer's queries do not "
                      "cover all of them"
                    : "");
    std::fflush(stdout);
}
