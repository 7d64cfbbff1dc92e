#include "common/timer.hpp"

#include <algorithm>
#include <cstdio>
#include <iomanip>
#include <iostream>
#include <numeric>
#include <sstream>
#include <stdexcept>

#include "common/files.hpp"

namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point begin)
{
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

bool has_queries()
{
    return GLEW_ARB_timer_query;
}

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

FrameTimer::Stage::Stage(FrameTimer* timer, const char* name) : timer_(timer)
{
    if (timer_ == nullptr) return;
    if (timer_->running_) throw std::logic_error(std::string("stage ") + name + " within a stage");
    timer_->running_ = true;
    FrameTime& frame = timer_->frames_.back();
    frame.stages.push_back({name, 0, {}});
    if (frame.synchronised) {
        glFinish();
    } else if (has_queries()) {
        timer_->pending_.push_back({timer_->forgotten_ + timer_->frames_.size() - 1,
                                    frame.stages.size() - 1, timer_->take_query(),
                                    timer_->take_query()});
        glQueryCounter(timer_->pending_.back().begin, GL_TIMESTAMP);
    }
    begin_ = Clock::now();
}

FrameTimer::Stage::~Stage()
{
    if (timer_ == nullptr) return;
    FrameTime& frame = timer_->frames_.back();
    StageTime& stage = frame.stages.back();
    stage.cpu_ms = milliseconds_since(begin_);
    if (frame.synchronised) {
        glFinish();
        stage.gpu_ms = milliseconds_since(begin_);
    } else if (has_queries()) {
        glQueryCounter(timer_->pending_.back().end, GL_TIMESTAMP);
    }
    timer_->running_ = false;
}

void FrameTimer::begin_frame(bool synchronised)
{
    frames_.push_back({0, synchronised, {}});
    open_ = true;
}

void FrameTimer::end_frame(double frame_ms)
{
    if (!open_) return;
    frames_.back().frame_ms = frame_ms;
    open_ = false;
    collect(false);
}

void FrameTimer::drop_frame()
{
    if (!open_) return;
    frames_.pop_back();
    open_ = false;
}

void FrameTimer::keep(size_t count)
{
    while (frames_.size() > count) {
        frames_.pop_front();
        ++forgotten_;
    }
}

void FrameTimer::clear()
{
    keep(0);
    open_ = false;
}

void FrameTimer::finish()
{
    collect(true);
}

// Takes in the timestamps that have arrived. The queries are answered in the order in which they
// were made, so the first that is not ready ends it; asking for its result would stall until it is.
void FrameTimer::collect(bool wait)
{
    while (!pending_.empty()) {
        const Pending& oldest = pending_.front();
        GLint ready = 0;
        if (!wait) glGetQueryObjectiv(oldest.end, GL_QUERY_RESULT_AVAILABLE, &ready);
        if (!wait && !ready) return;
        GLuint64 begin = 0, end = 0;  // ns
        glGetQueryObjectui64v(oldest.begin, GL_QUERY_RESULT, &begin);
        glGetQueryObjectui64v(oldest.end, GL_QUERY_RESULT, &end);
        if (oldest.frame >= forgotten_ && oldest.frame - forgotten_ < frames_.size()) {
            frames_[oldest.frame - forgotten_].stages[oldest.stage].gpu_ms =
                double(end - begin) * 1e-6;
        }
        free_queries_.insert(free_queries_.end(), {oldest.begin, oldest.end});
        pending_.pop_front();
    }
}

// As many query objects as the GPU is frames behind, used again and again; they go with the
// context.
GLuint FrameTimer::take_query()
{
    if (free_queries_.empty()) {
        free_queries_.resize(16);
        glGenQueries(16, free_queries_.data());
    }
    const GLuint query = free_queries_.back();
    free_queries_.pop_back();
    return query;
}

double FrameTimer::cost_of_a_stage()
{
    constexpr int count = 1000;
    FrameTimer timer;
    timer.begin_frame(false);
    const Clock::time_point begin = Clock::now();
    for (int i = 0; i < count; ++i) timer.stage("empty");
    const double cost = milliseconds_since(begin) / count;
    timer.finish();
    glDeleteQueries(GLsizei(timer.free_queries_.size()), timer.free_queries_.data());
    return cost;
}

double quantile(std::vector<double> values, double part)
{
    if (values.empty()) return 0;
    const size_t rank = std::min(values.size() - 1, size_t(part * double(values.size())));
    std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(rank), values.end());
    return values[rank];
}

void write_csv(const std::filesystem::path& path, const Options& options, glm::ivec2 size,
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
        csv << options.step.name << "," << options.variant << "," << options.weather.particles
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
